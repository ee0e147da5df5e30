namespace Engraver.Core.Geometry;

/// <summary>Positions along the Hilbert curve of order 16: near keys mean near points, which keeps the boxes of a packed tree small.</summary>
internal static class HilbertCurve
{
    private const double LastCell = 65535.0;

    /// <summary>One key for the middle of each box; the curve's square has the longer side of all boxes together.</summary>
    public static uint[] KeysOf(ReadOnlySpan<Bounds2D> boxes)
    {
        var all = Bounds2D.Empty;
        foreach (var box in boxes) all = all.Union(box);
        var extent = Math.Max(all.Width, all.Height);
        var scale = extent > 0.0 ? LastCell / extent : 0.0;
        var keys = new uint[boxes.Length];
        for (var i = 0; i < keys.Length; i++)
        {
            var x = (((boxes[i].MinX + boxes[i].MaxX) / 2.0) - all.MinX) * scale;
            var y = (((boxes[i].MinY + boxes[i].MaxY) / 2.0) - all.MinY) * scale;
            keys[i] = KeyOf((uint)Math.Clamp(x, 0.0, LastCell), (uint)Math.Clamp(y, 0.0, LastCell));
        }

        return keys;
    }

    private static uint KeyOf(uint x, uint y)
    {
        var key = 0u;
        for (var side = 1u << 15; side > 0; side >>= 1)
        {
            var right = (x & side) != 0;
            var upper = (y & side) != 0;
            key += side * side * ((right ? 3u : 0u) ^ (upper ? 1u : 0u));
            if (upper) continue;
            if (right) (x, y) = (65535u - x, 65535u - y);
            (x, y) = (y, x);
        }

        return key;
    }
}
