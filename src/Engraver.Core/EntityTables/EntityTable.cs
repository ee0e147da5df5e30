using Engraver.Core.Drawings;
using Engraver.Core.Geometry;

namespace Engraver.Core.EntityTables;

/// <summary>The paper's table with fixed slots: any number of rows of 16 doubles in millimetres, one row per directed segment. Immutable outside this folder's
/// stages.</summary>
/// <remarks>Paper 001 prints an array of 100 x 20; it is implemented as 16 slots without a limit of rows. Rows are stored in chunks: 8 bytes for each slot
/// whose values differ within its chunk (a flat line has four, five when it is in sequence), plus 4 for the entity index; ellipses and splines (kinds 4 and 5)
/// in a side column.</remarks>
public sealed class EntityTable
{
    private readonly SlotRows _slots = new();
    private readonly GrowingColumn<int> _entities = new();
    private readonly Dictionary<int, RationalCurve> _curves = [];

    internal EntityTable()
    {
    }

    public static EntityTable Empty { get; } = new();

    public int Count => _slots.Count;

    public EntityRow this[int row] => new(_slots.ChunkOf(row, out var place), place, _entities[row], CurveOf(row));

    /// <summary>The drawing entity of a row, without reading its slots.</summary>
    public int EntityIndexOf(int row) => _entities[row];

    /// <summary>True when a row is an ellipse or a spline.</summary>
    public bool HasFreeCurves => _curves.Count > 0;

    /// <summary>The exact curve of a row of kind 4 or 5 in millimetres and in the row's direction; null for the others.</summary>
    public RationalCurve? CurveOf(int row) => _curves.Count > 0 && _curves.TryGetValue(row, out var curve) ? curve : null;

    /// <summary>Every row as a segment; the table must have been analysed.</summary>
    public Segment[] ToSegments()
    {
        var segments = new Segment[Count];
        for (var row = 0; row < Count; row++) segments[row] = this[row].ToSegment();
        return segments;
    }

    internal EntitySlots CopySlots(int row) => _slots.Copy(row);

    internal void Append(in EntitySlots slots, int entityIndex, RationalCurve? curve)
    {
        if (curve is not null) _curves.Add(_slots.Count, curve);
        _slots.Add(slots);
        _entities.Add(entityIndex);
    }

    /// <summary>A new table of some of the rows, in the order given.</summary>
    public EntityTable Picking(ReadOnlySpan<int> rows)
    {
        var picked = new EntityTable();
        foreach (var row in rows) picked.Append(_slots.Copy(row), _entities[row], CurveOf(row));
        return picked;
    }
}
