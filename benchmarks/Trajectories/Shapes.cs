using Engraver.Core.Geometry;

namespace Engraver.Benchmarks.Trajectories;

/// <summary>The curves on which trajectories are measured (sace-xps-agie.md 3.4) and seeded random ones. Millimetres.</summary>
internal static class Shapes
{
    public static Segment Line(double x1, double y1, double x2, double y2) => Segment.FromLine(new Point2D(x1, y1), new Point2D(x2, y2));

    public static Segment Arc(double x, double y, double radius, double start, double sweep) => Segment.FromArc(new ArcSegment(new Point2D(x, y), radius, Angle.FromDegrees(start), Angle.FromDegrees(sweep)));

    public static IReadOnlyList<Segment> Circle(double radius) => [Arc(0.0, 0.0, radius, 0.0, 360.0)];

    public static IReadOnlyList<Segment> Ellipse(double first, double second) =>
        [Segment.FromCurve(new EllipseArc(default, new Vector3D(first, 0.0, 0.0), new Vector3D(0.0, second, 0.0), Angle.Zero, Angle.FullTurn).ToCurve())];

    public static IReadOnlyList<Segment> RoundedRectangle(double width, double height, double radius)
    {
        var (x, y) = ((width / 2.0) - radius, (height / 2.0) - radius);
        return
        [
            Line(-x, -y - radius, x, -y - radius), Arc(x, -y, radius, -90.0, 90.0), Line(x + radius, -y, x + radius, y), Arc(x, y, radius, 0.0, 90.0),
            Line(x, y + radius, -x, y + radius), Arc(-x, y, radius, 90.0, 90.0), Line(-x - radius, y, -x - radius, -y), Arc(-x, -y, radius, 180.0, 90.0),
        ];
    }

    /// <summary>The polyline of the reference, open, four edges and three corners.</summary>
    public static IReadOnlyList<Segment> Polyline { get; } = [Line(0.0, 0.0, 20.0, 0.0), Line(20.0, 0.0, 20.0, 10.0), Line(20.0, 10.0, 10.0, 15.0), Line(10.0, 15.0, 0.0, 10.0)];

    /// <summary>A smooth random curve: an ellipse, a spline open or closed, a chain of tangent lines and arcs.</summary>
    public static (IReadOnlyList<Segment> Segments, bool Closed) Random(int seed)
    {
        var random = new Random(seed);
        double Between(double low, double high) => low + ((high - low) * random.NextDouble());
        switch (seed % 4)
        {
            case 0:
                return (Ellipse(Between(5.0, 40.0), Between(2.0, 20.0)), true);
            case 1:
            case 2:
                var closed = seed % 4 == 1;
                var (count, x) = (4 + random.Next(6), 0.0);
                var points = new Vector3D[count];
                for (var i = 0; i < count; i++)
                {
                    var angle = 2.0 * Math.PI * i / count;
                    var radius = Between(8.0, 20.0);
                    points[i] = closed ? new Vector3D(radius * Math.Cos(angle), radius * Math.Sin(angle), 0.0) : new Vector3D(x += Between(5.0, 12.0), Between(-8.0, 8.0), 0.0);
                }

                return ([Segment.FromCurve(FitPointSpline.Through(points, null, null, closed))], closed);
            default:
                return (TangentChain(random), false);
        }
    }

    private static List<Segment> TangentChain(Random random)
    {
        var (chain, place, way) = (new List<Segment>(), default(Point2D), 0.0);
        for (var i = 0; i < 6; i++)
        {
            if (i % 2 == 0)
            {
                var end = place + Vector2D.FromPolar(1.0 + (20.0 * random.NextDouble()), Angle.FromDegrees(way));
                chain.Add(Segment.FromLine(place, end));
                place = end;
                continue;
            }

            var (radius, sweep) = (2.0 + (10.0 * random.NextDouble()), (random.Next(2) == 0 ? 1.0 : -1.0) * (20.0 + (100.0 * random.NextDouble())));
            var centre = place + Vector2D.FromPolar(radius, Angle.FromDegrees(way + (sweep > 0.0 ? 90.0 : -90.0)));
            var arc = Segment.FromArc(new ArcSegment(centre, radius, (place - centre).Direction, Angle.FromDegrees(sweep)));
            chain.Add(arc);
            (place, way) = (arc.End, way + sweep);
        }

        return chain;
    }
}
