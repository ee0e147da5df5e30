using Engraver.Core.Geometry;

namespace Engraver.TestKit;

/// <summary>Curves as CAD programs write them, intended or not: coincident, collinear and reversing control points, weights, cusps, ellipses of every flatness,
/// tiny and huge ones. The same for the same seed.</summary>
public static class DrawnCurves
{
    /// <summary>Shapes that have failed before, or are limiting cases of curves.</summary>
    public static IReadOnlyList<DrawnCurve> Known { get; } =
    [
        DrawnCurve.Bezier("a line with both ends doubled", [new(0, 0), new(0, 0), new(10, 0), new(10, 0)]),
        DrawnCurve.Bezier("a bend with a doubled start", [new(0, 0), new(0, 0), new(10, 5), new(10, 10)]),
        DrawnCurve.Bezier("a bend with a doubled end", [new(0, 0), new(5, 0), new(10, 10), new(10, 10)]),
        DrawnCurve.Bezier("a start drawn three times", [new(0, 0), new(0, 0), new(0, 0), new(10, 10), new(20, 0)]),
        DrawnCurve.Bezier("a doubled middle", [new(0, 0), new(10, 10), new(10, 10), new(20, 0)]),
        DrawnCurve.Bezier("a cusp", [new(0, 0), new(10, 10), new(0, 10), new(10, 0)]),
        DrawnCurve.Bezier("there and back on a line", [new(0, 0), new(30, 0), new(-20, 0), new(10, 0)]),
        DrawnCurve.Bezier("a straight line at uneven speed", [new(0, 0), new(1, 0), new(2, 0), new(10, 0)]),
        DrawnCurve.Bezier("a closed loop", [new(0, 0), new(20, 10), new(-20, 10), new(0, 0)]),
        DrawnCurve.Bezier("a heavy shoulder", [new(0, 0), new(5, 10), new(10, 0)], [1, 1000, 1]),
        DrawnCurve.Bezier("a light shoulder", [new(0, 0), new(5, 10), new(10, 0)], [1, 0.001, 1]),
        DrawnCurve.Spline("a doubled inner point with its knot", 3, [0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 2], [new(0, 0), new(3, 4), new(10, 5), new(10, 5), new(10, 5), new(14, 4), new(20, 0)]),
        DrawnCurve.Spline("three equal inner points", 3, [0, 0, 0, 0, 1, 2, 3, 4, 4, 4, 4], [new(0, 0), new(5, 5), new(10, 0), new(10, 0), new(10, 0), new(15, 5), new(20, 0)]),
        DrawnCurve.Ellipse("an ellipse that is a line", Flat(0.0, 0.0, 360.0)),
        DrawnCurve.Ellipse("a quarter of an ellipse that is a line", Flat(0.0, 0.0, 90.0)),
        DrawnCurve.Ellipse("a hair of an ellipse", Flat(1e-6, 10.0, 300.0)),
    ];

    /// <summary>Curves of a seed, all kinds in turn, ten millimetres in size.</summary>
    public static IEnumerable<DrawnCurve> Random(int seed, int count) => Random(seed, count, 10.0);

    /// <param name="size">Approximate size.</param>
    public static IEnumerable<DrawnCurve> Random(int seed, int count, double size)
    {
        var random = new Random(seed);
        for (var i = 0; i < count; i++) yield return i % 4 == 3 ? AnEllipse($"ellipse {i} of seed {seed}", random, size) : ASpline($"spline {i} of seed {seed}", random, size);
    }

    private static EllipseArc Flat(double ratio, double start, double sweep) => FreeCurves.Ellipse(3.0, -2.0, 10.0, ratio, 30.0, start, sweep);

    private static DrawnCurve AnEllipse(string name, Random random, double size)
    {
        var ratio = random.Next(6) == 0 ? 0.0 : Math.Pow(10.0, -5.0 * random.NextDouble());
        var sweep = random.Next(3) == 0 ? 360.0 : 1.0 + (358.0 * random.NextDouble());
        return DrawnCurve.Ellipse(name, FreeCurves.Ellipse(size * Even(random), size * Even(random), size * (0.1 + random.NextDouble()), ratio, 360.0 * random.NextDouble(), 360.0 * random.NextDouble(), sweep));
    }

    private static DrawnCurve ASpline(string name, Random random, double size)
    {
        var degree = 2 + random.Next(4);
        var points = Points(random, degree + 1 + random.Next(4), size);
        var weights = random.Next(3) == 0 ? [.. points.Select(_ => Math.Pow(10.0, 2.0 * Even(random)))] : points.Select(_ => 1.0).ToArray();
        return DrawnCurve.Spline(name, degree, Knots(random, degree, points.Length), points, weights);
    }

    /// <summary>Each point is new, or equal to the previous one, or on the line of the last two (forwards or back).</summary>
    private static Point2D[] Points(Random random, int count, double size)
    {
        var points = new Point2D[count];
        points[0] = new Point2D(size * Even(random), size * Even(random));
        for (var i = 1; i < count; i++)
        {
            var kind = random.Next(8);
            if (kind < 2) points[i] = points[i - 1];
            else if (kind < 4 && i > 1) points[i] = points[i - 1] + ((points[i - 1] - points[i - 2]) * (2.0 * Even(random)));
            else points[i] = new Point2D(size * Even(random), size * Even(random));
        }

        if (points.All(point => point == points[0])) points[^1] = points[0] + new Vector2D(size, 0.5 * size);
        return points;
    }

    /// <summary>Clamped at both ends; inner knots single, double or with the multiplicity of the degree.</summary>
    private static double[] Knots(Random random, int degree, int points)
    {
        var knots = new double[points + degree + 1];
        var (value, times) = (0.0, 0);
        for (var i = degree + 1; i < points; i++)
        {
            if (value == 0.0 || times == degree || random.Next(3) > 0) (value, times) = (value + 0.2 + random.NextDouble(), 0);
            (knots[i], times) = (value, times + 1);
        }

        Array.Fill(knots, value + 1.0, points, degree + 1);
        return knots;
    }

    /// <summary>From -1 to 1.</summary>
    private static double Even(Random random) => (2.0 * random.NextDouble()) - 1.0;
}
