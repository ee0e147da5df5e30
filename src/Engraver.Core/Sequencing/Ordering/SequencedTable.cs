using Engraver.Core.EntityTables;
using Engraver.Core.Sequencing.Chaining;

namespace Engraver.Core.Sequencing.Ordering;

/// <summary>Writes the table in the order of cutting: rows reversed where the contour runs them backwards, circles started at the arrival point of the tool,
/// slot 13 numbered from 1.</summary>
internal static class SequencedTable
{
    /// <returns>The table, and the number of rows that run against their drawn direction.</returns>
    public static (EntityTable Table, int Reversed) Write(ChainedTable chained, IReadOnlyList<StrokeEntry> entries)
    {
        var table = new EntityTable();
        var reversed = 0;
        foreach (var entry in entries)
        {
            var pieces = chained.Chain.Contours[entry.Contour].Pieces;
            for (var step = 0; step < pieces.Length; step++)
            {
                var piece = PieceAt(entry, pieces.Span, step);
                if (piece.Reversed) reversed++;
                Append(table, chained.Kept, piece, entry);
            }
        }

        return (table, reversed);
    }

    private static ContourPiece PieceAt(StrokeEntry entry, ReadOnlySpan<ContourPiece> pieces, int step) => entry.Kind == StrokeEntryKind.Turned
        ? pieces[pieces.Length - 1 - step].Turned()
        : pieces[(entry.Piece + step) % pieces.Length];

    private static void Append(EntityTable table, EntityTable from, ContourPiece piece, StrokeEntry entry)
    {
        var slots = from.CopySlots(piece.Row);
        if (piece.Reversed) slots.Reverse();
        if (entry.Kind == StrokeEntryKind.OnCircle) slots.StartCircleAt((entry.Place - slots.Centre).Direction);
        slots[EntitySlot.SequenceNumber] = table.Count + 1;
        var curve = from.CurveOf(piece.Row);
        table.Append(slots, from.EntityIndexOf(piece.Row), piece.Reversed ? curve?.Reversed() : curve);
    }
}
