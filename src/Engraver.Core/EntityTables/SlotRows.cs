using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;

namespace Engraver.Core.EntityTables;

/// <summary>The slots of a table's rows, in chunks. A slot that is the same in all rows of a chunk (the arc slots of lines, heights of a flat drawing) is one
/// number; the others of a row are adjacent in memory, because rows are read in the order of cutting, which differs from the order of the file.</summary>
internal sealed class SlotRows
{
    private const int ChunkShift = 10;
    private const int ChunkSize = 1 << ChunkShift;
    private readonly List<SlotChunk> _chunks = [];

    public int Count { get; private set; }

    public void Add(in EntitySlots slots)
    {
        var place = Count & (ChunkSize - 1);
        if (place == 0) _chunks.Add(new SlotChunk(slots));
        _chunks[^1].Write(place, slots);
        Count++;
    }

    public EntitySlots Copy(int row) => ChunkOf(row, out var place).Copy(place);

    /// <summary>The chunk of a row, for a row that is read slot by slot.</summary>
    public SlotChunk ChunkOf(int row, out int place)
    {
        if ((uint)row >= (uint)Count) throw new ArgumentOutOfRangeException(nameof(row));
        place = row & (ChunkSize - 1);
        return _chunks[row >> ChunkShift];
    }

    /// <param name="first">The chunk's first row.</param>
    internal sealed class SlotChunk(in EntitySlots first)
    {
        /// <summary>The value of all rows where they do not differ.</summary>
        private readonly EntitySlots _first = first;

        /// <summary>For each slot its index among those that differ; negative for the others.</summary>
        private PlacesOfSlots _placeOf = PlacesOfSlots.AllSame;

        /// <summary>The slots that differ, in the order in which they first differed.</summary>
        private PlacesOfSlots _differing;
        private int _width;

        /// <summary>A bit for each slot that is the same in all rows.</summary>
        private uint _same = (1U << EntitySlot.Count) - 1;

        /// <summary>Row by row the slots that differ.</summary>
        private double[] _cells = [];

        public double this[int place, int slot] => _placeOf[slot] is >= 0 and var at ? _cells[(place * _width) + at] : _first[slot];

        public EntitySlots Copy(int place)
        {
            var slots = _first;
            var row = _cells.AsSpan(place * _width, _width);
            for (var at = 0; at < row.Length; at++) slots[_differing[at]] = row[at];
            return slots;
        }

        public void Write(int place, in EntitySlots slots)
        {
            var width = _width;
            for (var begun = Unlike(slots, _first) & _same; begun != 0; begun &= begun - 1) Begin(BitOperations.TrailingZeroCount(begun));
            if (_width > width) Widen(width, place);
            var row = _cells.AsSpan(place * _width, _width);
            for (var at = 0; at < row.Length; at++) row[at] = slots[_differing[at]];
        }

        private void Begin(int slot)
        {
            _differing[_width] = (sbyte)slot;
            _placeOf[slot] = (sbyte)_width++;
            _same &= ~(1U << slot);
        }

        /// <summary>A bit for each slot whose eight bytes differ: a negative zero is not a zero.</summary>
        private static uint Unlike(in EntitySlots left, in EntitySlots right)
        {
            var ours = MemoryMarshal.Cast<double, Vector256<long>>(left);
            var theirs = MemoryMarshal.Cast<double, Vector256<long>>(right);
            var unlike = 0U;
            for (var part = 0; part < ours.Length; part++) unlike |= (~Vector256.Equals(ours[part], theirs[part])).ExtractMostSignificantBits() << (part * Vector256<long>.Count);
            return unlike;
        }

        /// <summary>Adds space for slots that differ from now on; they were the same in all rows so far.</summary>
        private void Widen(int before, int rows)
        {
            var cells = GC.AllocateUninitializedArray<double>(ChunkSize * _width);
            for (var place = 0; place < rows; place++)
            {
                _cells.AsSpan(place * before, before).CopyTo(cells.AsSpan(place * _width));
                for (var at = before; at < _width; at++) cells[(place * _width) + at] = _first[_differing[at]];
            }

            _cells = cells;
        }
    }

    [InlineArray(EntitySlot.Count)]
    private struct PlacesOfSlots
    {
        private sbyte _first;

        public static PlacesOfSlots AllSame
        {
            get
            {
                var places = default(PlacesOfSlots);
                ((Span<sbyte>)places).Fill(-1);
                return places;
            }
        }
    }
}
