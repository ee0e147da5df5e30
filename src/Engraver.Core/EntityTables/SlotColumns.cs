namespace Engraver.Core.EntityTables;

/// <summary>The slots of a table's rows as columns, in chunks. A column that is the same in all rows of a chunk (what lines have in the slots of arcs, heights of a flat drawing) is one number.</summary>
internal sealed class SlotColumns
{
    private const int ChunkShift = 12;
    private const int ChunkSize = 1 << ChunkShift;
    private readonly List<SlotChunk> _chunks = [];

    public int Count { get; private set; }

    public void Add(in EntitySlots slots)
    {
        var place = Count & (ChunkSize - 1);
        if (place == 0) _chunks.Add(new SlotChunk());
        _chunks[^1].Write(place, slots);
        Count++;
    }

    public EntitySlots Copy(int row)
    {
        if ((uint)row >= (uint)Count) throw new ArgumentOutOfRangeException(nameof(row));
        var (chunk, place) = (_chunks[row >> ChunkShift], row & (ChunkSize - 1));
        var slots = default(EntitySlots);
        for (var slot = 0; slot < EntitySlot.Count; slot++) slots[slot] = chunk[place, slot];
        return slots;
    }

    /// <summary>The chunk of a row, for a row that is read slot by slot.</summary>
    public SlotChunk ChunkOf(int row, out int place)
    {
        if ((uint)row >= (uint)Count) throw new ArgumentOutOfRangeException(nameof(row));
        place = row & (ChunkSize - 1);
        return _chunks[row >> ChunkShift];
    }

    internal sealed class SlotChunk
    {
        private readonly double[]?[] _columns = new double[]?[EntitySlot.Count];

        /// <summary>Of each slot the value of the first row: that of all rows where there is no column.</summary>
        private EntitySlots _first;

        public double this[int place, int slot] => _columns[slot] is { } column ? column[place] : _first[slot];

        public void Write(int place, in EntitySlots slots)
        {
            if (place == 0) _first = slots;
            for (var slot = 0; slot < EntitySlot.Count; slot++)
            {
                if (_columns[slot] is { } column) column[place] = slots[slot];
                else if (BitConverter.DoubleToInt64Bits(slots[slot]) != BitConverter.DoubleToInt64Bits(_first[slot])) Begin(slot, place)[place] = slots[slot];
            }
        }

        private double[] Begin(int slot, int place)
        {
            var column = GC.AllocateUninitializedArray<double>(ChunkSize);
            Array.Fill(column, _first[slot], 0, place);
            return _columns[slot] = column;
        }
    }
}
