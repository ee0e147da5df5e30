using Engraver.Core.Geometry;

namespace Engraver.App.Canvas.Scenes;

/// <summary>Sorts primitives so that neighbours in the drawing are neighbours in memory: by size class, then along the Morton curve. Equal keys keep the
/// order of the drawing.</summary>
internal static class MortonOrder
{
    private const int SampleCount = 1024;
    private const int DigitBits = 11;
    private const int Digits = 3;
    private const double LastCell = 32767.0;

    /// <summary>Borders between the size classes, as fractions of the frame: primitives longer than a quarter, a sixteenth or a 64th of it do not share a
    /// block with smaller ones.</summary>
    private static readonly double[] s_classes = [1.0 / 4.0, 1.0 / 16.0, 1.0 / 64.0];

    /// <summary>The order in memory: the index of the primitive for each position.</summary>
    public static int[] Sort(ReadOnlyMemory<Bounds2D> boxes)
    {
        var frame = FrameOf(boxes.Span);
        var keys = new uint[boxes.Length];
        var scale = LastCell / Math.Max(double.Epsilon, Math.Max(frame.Width, frame.Height));
        if (!double.IsFinite(scale)) scale = 0.0;
        Parallel.ForEach(CoreRanges.Split(boxes.Length), range =>
        {
            for (var i = range.From; i < range.To; i++) keys[i] = KeyOf(boxes.Span[i], frame, scale);
        });
        return Sorted(keys);
    }

    /// <summary>The box of most of the drawing: a stray point far away must not put all other primitives into one cell.</summary>
    private static Bounds2D FrameOf(ReadOnlySpan<Bounds2D> boxes)
    {
        if (boxes.IsEmpty) return new Bounds2D(0.0, 0.0, 1.0, 1.0);
        var count = Math.Min(SampleCount, boxes.Length);
        var (x, y) = (new double[count], new double[count]);
        for (var i = 0; i < count; i++)
        {
            ref readonly var box = ref boxes[(int)((long)i * boxes.Length / count)];
            (x[i], y[i]) = ((box.MinX + box.MaxX) / 2.0, (box.MinY + box.MaxY) / 2.0);
        }

        Array.Sort(x);
        Array.Sort(y);
        var (low, high) = (count / 50, count - 1 - (count / 50));
        var (spareX, spareY) = ((x[high] - x[low]) / 10.0, (y[high] - y[low]) / 10.0);
        return new Bounds2D(x[low] - spareX, y[low] - spareY, x[high] + spareX, y[high] + spareY);
    }

    private static uint KeyOf(in Bounds2D box, in Bounds2D frame, double scale)
    {
        var x = Math.Clamp((((box.MinX + box.MaxX) / 2.0) - frame.MinX) * scale, 0.0, LastCell);
        var y = Math.Clamp((((box.MinY + box.MaxY) / 2.0) - frame.MinY) * scale, 0.0, LastCell);
        return (SizeClass(box, frame) << 30) | Spread((uint)x) | (Spread((uint)y) << 1);
    }

    private static uint SizeClass(in Bounds2D box, in Bounds2D frame)
    {
        var size = Math.Max(box.MaxX - box.MinX, box.MaxY - box.MinY);
        var whole = Math.Max(frame.Width, frame.Height);
        return size > whole * s_classes[0] ? 0u : size > whole * s_classes[1] ? 1u : size > whole * s_classes[2] ? 2u : 3u;
    }

    /// <summary>Inserts a zero between the bits.</summary>
    private static uint Spread(uint value)
    {
        value = (value | (value << 8)) & 0x00FF00FF;
        value = (value | (value << 4)) & 0x0F0F0F0F;
        value = (value | (value << 2)) & 0x33333333;
        return (value | (value << 1)) & 0x55555555;
    }

    /// <summary>Radix sort from the lowest digit up: stable and linear.</summary>
    private static int[] Sorted(uint[] keys)
    {
        var order = new int[keys.Length];
        for (var i = 0; i < order.Length; i++) order[i] = i;
        var (nextKeys, nextOrder) = (new uint[keys.Length], new int[keys.Length]);
        var starts = new int[1 << DigitBits];
        for (var digit = 0; digit < Digits; digit++)
        {
            Distribute(digit * DigitBits, starts, keys, order, nextKeys, nextOrder);
            (keys, nextKeys) = (nextKeys, keys);
            (order, nextOrder) = (nextOrder, order);
        }

        return order;
    }

    private static void Distribute(int shift, int[] starts, uint[] keys, int[] order, uint[] nextKeys, int[] nextOrder)
    {
        const uint Mask = (1u << DigitBits) - 1u;
        Array.Clear(starts);
        foreach (var key in keys) starts[(key >> shift) & Mask]++;
        var sum = 0;
        for (var i = 0; i < starts.Length; i++) (starts[i], sum) = (sum, sum + starts[i]);
        for (var i = 0; i < keys.Length; i++)
        {
            var place = starts[(keys[i] >> shift) & Mask]++;
            (nextKeys[place], nextOrder[place]) = (keys[i], order[i]);
        }
    }
}
