using Engraver.Core.EntityTables;
using Engraver.Core.Geometry;
using Engraver.Core.Sequencing.Chaining;

namespace Engraver.Core.Sequencing.ArcRecovery;

/// <summary>Collects the replacements and writes the new table.</summary>
internal sealed class ArcReplacement(EntityTable table)
{
    private readonly Dictionary<int, (RecoveredArc Arc, int Lines)> _arcs = [];
    private readonly bool[] _replaced = new bool[table.Count];

    public void Add(ReadOnlySpan<ContourPiece> pieces, in RecoveredArc arc)
    {
        var lowest = int.MaxValue;
        foreach (var piece in pieces)
        {
            _replaced[piece.Row] = true;
            lowest = Math.Min(lowest, piece.Row);
        }

        _arcs.Add(lowest, (arc, pieces.Length));
    }

    public ArcRecoveryResult ToResult()
    {
        if (_arcs.Count == 0) return new ArcRecoveryResult(table, []);
        var (written, notes) = (new EntityTable(), new List<ArcRecoveryNote>());
        for (var row = 0; row < table.Count; row++)
        {
            if (_arcs.TryGetValue(row, out var found))
            {
                notes.Add(new ArcRecoveryNote(written.Count, found.Lines, found.Arc.Deviation));
                written.Append(SlotsOf(found.Arc, table[row][EntitySlot.StartZ]), table.EntityIndexOf(row), null);
            }
            else if (!_replaced[row])
            {
                written.Append(table.CopySlots(row), table.EntityIndexOf(row), table.CurveOf(row));
            }
        }

        return new ArcRecoveryResult(written, notes);
    }

    /// <summary>The slots of an analysed row.</summary>
    private static EntitySlots SlotsOf(in RecoveredArc recovered, double z)
    {
        var arc = recovered.Arc;
        var slots = default(EntitySlots);
        slots[EntitySlot.Kind] = (int)(arc.IsFullTurn ? SegmentKind.Circle : SegmentKind.Arc);
        slots.SetCentre(arc.Centre, z);
        slots[EntitySlot.Radius] = arc.Radius;
        slots[EntitySlot.Sweep] = arc.Sweep.Degrees;
        if (arc.IsFullTurn)
        {
            slots.StartCircleAt(Angle.Zero);
            return slots;
        }

        slots.SetStart(recovered.Start, z);
        slots.SetEnd(recovered.End, z);
        slots[EntitySlot.StartAngle] = arc.Start.Degrees;
        slots[EntitySlot.EndAngle] = (arc.Start + arc.Sweep).Positive().Degrees;
        return slots;
    }
}
