namespace Engraver.Benchmarks.Motion.Parts;

/// <summary>A polyline of lines and arcs.</summary>
/// <param name="Vertices">With the bulge of the side after each: the tangent of a quarter of the angle of its arc, positive to the left.</param>
internal sealed record Outline(IReadOnlyList<(double X, double Y, double Bulge)> Vertices, bool IsClosed)
{
    public static Outline Closed(params (double X, double Y, double Bulge)[] vertices) => new(vertices, true);

    public static Outline Open(params (double X, double Y, double Bulge)[] vertices) => new(vertices, false);

    public static Outline Circle(double x, double y, double radius) => Closed((x - radius, y, 1.0), (x + radius, y, 1.0));

    public Outline At(double x, double y, double scale) =>
        this with { Vertices = [.. Vertices.Select(vertex => (x + (scale * vertex.X), y + (scale * vertex.Y), vertex.Bulge))] };
}
