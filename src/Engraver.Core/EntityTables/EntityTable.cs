using Engraver.Core.Drawings;
using Engraver.Core.Geometry;

namespace Engraver.Core.EntityTables;

/// <summary>The paper's fixed-slot table: any number of rows of 16 doubles in millimetres, one row per directed segment. Immutable outside this folder's stages.</summary>
/// <remarks>Paper 001 prints an array of 100 x 20; the reading is 16 slots and no limit. Rows live in chunks, 128 bytes each plus 4 for the entity index.</remarks>
public sealed class EntityTable
{
    private readonly GrowingColumn<EntitySlots> _slots = new();
    private readonly GrowingColumn<int> _entities = new();

    internal EntityTable()
    {
    }

    public static EntityTable Empty { get; } = new();

    public int Count => _slots.Count;

    public EntityRow this[int row] => new(_slots[row], _entities[row]);

    /// <summary>The drawing entity of a row, without touching its slots.</summary>
    public int EntityIndexOf(int row) => _entities[row];

    /// <summary>Every row as a segment; the table must have been analysed.</summary>
    public Segment[] ToSegments()
    {
        var segments = new Segment[Count];
        for (var row = 0; row < Count; row++) segments[row] = this[row].ToSegment();
        return segments;
    }

    internal EntitySlots CopySlots(int row) => _slots[row];

    internal void Append(in EntitySlots slots, int entityIndex)
    {
        _slots.Add(slots);
        _entities.Add(entityIndex);
    }

    /// <summary>A new table of some of the rows, in the order given.</summary>
    internal EntityTable Picking(ReadOnlySpan<int> rows)
    {
        var picked = new EntityTable();
        foreach (var row in rows) picked.Append(_slots[row], _entities[row]);
        return picked;
    }
}
