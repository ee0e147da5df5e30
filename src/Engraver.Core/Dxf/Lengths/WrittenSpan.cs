namespace Engraver.Core.Dxf.Lengths;

/// <summary>The turn of a curve between its two written angles, at most one turn.</summary>
internal static class WrittenSpan
{
    /// <summary>Angles nearer than this are equal: such a curve has no length, which is reported (DXF0010).</summary>
    private const double Equal = 1e-9;

    /// <summary>
    /// End minus start where it is positive. Where it is negative, a curve between usual angles (0 to a turn, or half a turn to each side) crosses the angle at
    /// which these begin again; between others it is taken as clockwise, as written.
    /// </summary>
    public static double Of(double start, double end, double turn)
    {
        var raw = end - start;
        if (Math.Abs(raw) <= Equal) return 0.0;
        if (raw > 0.0 || !(AreWithin(start, end, 0.0, turn) || AreWithin(start, end, -turn / 2.0, turn / 2.0))) return Math.Min(Math.Abs(raw), turn);
        return raw + turn > Equal ? raw + turn : turn;
    }

    private static bool AreWithin(double start, double end, double low, double high) => Math.Min(start, end) >= low && Math.Max(start, end) <= high;
}

/// <summary>The length of a smooth curve from a few chords: never more than the true length, and of the right magnitude.</summary>
internal static class SampledChords
{
    private const int Count = 16;

    public static double Length(double start, double span, Func<double, (double X, double Y)> place)
    {
        if (span == 0.0) return 0.0;
        var (sum, last) = (0.0, place(start));
        for (var i = 1; i <= Count; i++)
        {
            var next = place(start + (span * i / Count));
            sum += Math.Sqrt(((next.X - last.X) * (next.X - last.X)) + ((next.Y - last.Y) * (next.Y - last.Y)));
            last = next;
        }

        return sum;
    }
}

/// <summary>The vertices of a polyline in plan, each with the bulge of the part that begins there.</summary>
internal sealed class VertexChain
{
    private readonly List<(double X, double Y, double Bulge)> _vertices = [];

    public void Clear() => _vertices.Clear();

    public void Add(double x, double y, double bulge) => _vertices.Add((x, y, bulge));

    public void SetY(double y)
    {
        if (_vertices.Count > 0) _vertices[^1] = _vertices[^1] with { Y = y };
    }

    public void SetBulge(double bulge)
    {
        if (_vertices.Count > 0) _vertices[^1] = _vertices[^1] with { Bulge = bulge };
    }

    /// <param name="closed">True when the last vertex is joined to the first.</param>
    /// <param name="bent">False when bulges are ignored.</param>
    public double Length(bool closed, bool bent)
    {
        var sum = 0.0;
        for (var i = 1; i < _vertices.Count; i++) sum += Part(_vertices[i - 1], _vertices[i], bent);
        return closed && _vertices.Count > 1 ? sum + Part(_vertices[^1], _vertices[0], bent) : sum;
    }

    /// <summary>An arc over a chord c with bulge b, the tangent of a quarter of its angle, has the radius c (1 + b^2) / 4b and turns by 4 atan b.</summary>
    private static double Part((double X, double Y, double Bulge) from, (double X, double Y, double Bulge) to, bool bent)
    {
        var chord = Math.Sqrt(((to.X - from.X) * (to.X - from.X)) + ((to.Y - from.Y) * (to.Y - from.Y)));
        var bulge = Math.Abs(from.Bulge);
        return !bent || bulge < 1e-6 ? chord : chord * (1.0 + (bulge * bulge)) / bulge * Math.Atan(bulge);
    }
}
