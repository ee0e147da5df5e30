namespace Engraver.Samples.Geometry;

/// <summary>Draws one contour piece by piece, from where it was put down. Sweeps are in degrees, counter-clockwise positive.</summary>
internal sealed class Pen
{
    private readonly List<Vertex> vertices;

    private Pen(Point start) => vertices = [new Vertex(start)];

    public static Pen At(Point start) => new(start);

    public static Pen At(double x, double y) => new(new Point(x, y));

    public Pen LineTo(Point end)
    {
        vertices.Add(new Vertex(end));
        return this;
    }

    public Pen LineTo(double x, double y) => LineTo(new Point(x, y));

    public Pen ArcTo(Point end, double sweep)
    {
        BendLast(sweep);
        return LineTo(end);
    }

    public Pen ArcTo(double x, double y, double sweep) => ArcTo(new Point(x, y), sweep);

    /// <summary>An arc about <paramref name="centre"/>; its end follows from the sweep.</summary>
    public Pen ArcAbout(Point centre, double sweep) => ArcTo(centre + (vertices[^1].At - centre).Rotated(sweep), sweep);

    public Contour Close() => new(vertices, Closed: true);

    /// <summary>Closes with an arc back to the start.</summary>
    public Contour CloseWithArc(double sweep)
    {
        BendLast(sweep);
        return Close();
    }

    public Contour Lift() => new(vertices, Closed: false);

    private void BendLast(double sweep) => vertices[^1] = vertices[^1] with { Bulge = Math.Tan(double.DegreesToRadians(sweep) / 4) };
}
