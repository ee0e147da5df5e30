using Engraver.Samples.Dxf;

namespace Engraver.Samples.Geometry;

/// <summary>Lines and arcs joined end to start. Neighbours share one vertex, so their ends are the same decimals in the file.</summary>
internal sealed record Contour(IReadOnlyList<Vertex> Vertices, bool Closed)
{
    public Contour Moved(double x, double y) => Mapped(point => point + new Point(x, y));

    /// <summary>Turned counter-clockwise about the origin.</summary>
    public Contour Rotated(double degrees) => Mapped(point => point.Rotated(degrees));

    /// <summary>Enlarged about the origin by a positive factor.</summary>
    public Contour Scaled(double factor) => Mapped(point => point * factor);

    /// <summary>The whole contour as one polyline with bulges.</summary>
    public PolylineEntity AsPolyline(string layer) => new(layer, Vertices, Closed);

    /// <summary>The contour taken apart into LINE and ARC entities, in contour order.</summary>
    public IEnumerable<DxfEntity> AsLinesAndArcs(string layer)
    {
        var pieces = Closed ? Vertices.Count : Vertices.Count - 1;
        for (var i = 0; i < pieces; i++)
        {
            var from = Vertices[i];
            var to = Vertices[(i + 1) % Vertices.Count].At;
            yield return from.Bulge == 0 ? new LineEntity(layer, from.At, to) : ArcBetween(layer, from, to);
        }
    }

    private static ArcEntity ArcBetween(string layer, Vertex from, Point to)
    {
        var sweep = 4 * Math.Atan(from.Bulge);
        var chord = to - from.At;
        var centre = from.At + (chord * 0.5) + (chord.Left * (0.5 / Math.Tan(sweep / 2)));
        var radius = chord.Length / 2 / Math.Abs(Math.Sin(sweep / 2));
        var (start, end) = ((from.At - centre).Degrees, (to - centre).Degrees);
        return sweep > 0 ? new(layer, centre, radius, start, end) : new(layer, centre, radius, end, start);
    }

    /// <remarks>The map must keep the orientation: bulges are carried over with their sign.</remarks>
    private Contour Mapped(Func<Point, Point> map) => this with { Vertices = [.. Vertices.Select(v => v with { At = map(v.At) })] };
}
