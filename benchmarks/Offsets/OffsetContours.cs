using Engraver.Core.Geometry;
using Engraver.Core.Offsets;

namespace Engraver.Benchmarks.Offsets;

/// <summary>Closed contours with a given number of vertices, millimetres, for measuring offsets. More vertices make them finer: at 100,000 the teeth of a comb
/// are far narrower than the distance.</summary>
internal static class OffsetContours
{
    private const double WholeTurn = 2.0 * Math.PI;

    /// <summary>The contours by their names in the table.</summary>
    public static IReadOnlyList<(string Name, Func<int, OffsetContour> Create)> All { get; } =
    [
        ("circle of chords", Chords), ("wavy", Wavy), ("random", Noise), ("star", count => Rings(count, 100.0, 90.0, 1)), ("comb", count => Rings(count, 1000.0, 990.0, 2)), ("straight comb", StraightComb), ("gear", Gear), ("spiral", Spiral),
    ];

    /// <summary>Radius 100.</summary>
    private static OffsetContour Chords(int count) => Round(count, (_, _) => 100.0);

    /// <summary>Radius 100 with waves of 20 and of 5.</summary>
    private static OffsetContour Wavy(int count) => Round(count, (_, angle) => 100.0 + (20.0 * Math.Sin(7.0 * angle)) + (5.0 * Math.Sin(31.0 * angle)));

    /// <summary>Radius 100 to 101 at random, seed 1.</summary>
    private static OffsetContour Noise(int count)
    {
        var random = new Random(1);
        return Round(count, (_, _) => 100.0 + random.NextDouble());
    }

    /// <summary>The same number of vertices on two radii, alternating.</summary>
    private static OffsetContour Rings(int count, double outer, double inner, int each) => Round(count, (i, _) => i / each % 2 == 0 ? outer : inner);

    /// <summary>Upright teeth of 10 mm on a bar 1000 long and 20 high.</summary>
    private static OffsetContour StraightComb(int count)
    {
        var teeth = (count - 2) / 4;
        var width = 1000.0 / ((2 * teeth) - 1);
        var places = new List<Point2D>(count);
        for (var tooth = 0; tooth < teeth; tooth++)
        {
            var (left, right) = (2 * tooth * width, ((2 * tooth) + 1) * width);
            places.AddRange([new(left, 0.0), new(left, 10.0), new(right, 10.0), new(right, 0.0)]);
        }

        return Polygon([.. places, new(1000.0, -20.0), new(0.0, -20.0)]);
    }

    /// <summary>Arcs on the radii 1000 and 990, flanks of 10 mm.</summary>
    private static OffsetContour Gear(int count)
    {
        var segments = new List<Segment>(count);
        var step = WholeTurn / (count / 2);
        for (var i = 0; i < count / 2; i++)
        {
            var (radius, next) = i % 2 == 0 ? (1000.0, 990.0) : (990.0, 1000.0);
            var (start, end) = (At(i * step, radius), At((i + 1) * step, radius));
            segments.Add(Segment.FromArc(new ArcSegment(default, radius, Angle.FromRadians(i * step), Angle.FromRadians(step)), start, end));
            segments.Add(Segment.FromLine(end, At((i + 1) * step, next)));
        }

        return new OffsetContour(segments, true);
    }

    /// <summary>A band of 5 mm that winds outwards 20 times with gaps of 5 mm.</summary>
    private static OffsetContour Spiral(int count)
    {
        var half = count / 2;
        var places = new Point2D[2 * half];
        for (var i = 0; i < half; i++)
        {
            var angle = 20.0 * WholeTurn * i / (half - 1);
            (places[i], places[^(i + 1)]) = (At(angle, 25.0 + (10.0 * angle / WholeTurn)), At(angle, 20.0 + (10.0 * angle / WholeTurn)));
        }

        return Polygon(places);
    }

    private static OffsetContour Round(int count, Func<int, double, double> radius)
    {
        var places = new Point2D[count];
        for (var i = 0; i < count; i++) places[i] = At(WholeTurn * i / count, radius(i, WholeTurn * i / count));
        return Polygon(places);
    }

    private static Point2D At(double angle, double radius) => new(radius * Math.Cos(angle), radius * Math.Sin(angle));

    private static OffsetContour Polygon(Point2D[] places)
    {
        var segments = new Segment[places.Length];
        for (var i = 0; i < segments.Length; i++) segments[i] = Segment.FromLine(places[i], places[(i + 1) % places.Length]);
        return new OffsetContour(segments, true);
    }
}
