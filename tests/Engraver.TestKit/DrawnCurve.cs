using Engraver.Core.Geometry;

namespace Engraver.TestKit;

/// <summary>A curve as drawn, with an independent evaluation (de Boor on the knots, cosine and sine of the ellipse) that shares no code with the product. Also
/// contains the product's curve of the same numbers.</summary>
/// <param name="Name">Printed by a failing test.</param>
/// <param name="Curve">The curve of the product.</param>
/// <param name="Breaks">Parameters between which the curve is smooth, ascending.</param>
/// <param name="At">The point at a parameter between the first break and the last.</param>
/// <param name="Size">Width and height of the defining numbers, together.</param>
public sealed record DrawnCurve(string Name, RationalCurve Curve, IReadOnlyList<double> Breaks, Func<double, Point2D> At, double Size)
{
    /// <summary>Number of places of the coarse search between two breaks.</summary>
    private const int CoarseSteps = 200;

    private static readonly double s_golden = (Math.Sqrt(5.0) - 1.0) / 2.0;

    public static DrawnCurve Spline(string name, int degree, double[] knots, Point2D[] points, double[]? weights = null)
    {
        var weight = weights ?? [.. points.Select(_ => 1.0)];
        double[] homogeneous = [.. points.SelectMany((point, i) => new[] { point.X * weight[i], point.Y * weight[i], 0.0, weight[i] })];
        var curve = new NurbsCurve(degree, knots, homogeneous).ToCurve()!;
        double[] breaks = [.. knots[degree..(points.Length + 1)].Distinct().Order()];
        return new DrawnCurve(name, curve, breaks, at => DeBoor(degree, knots, points, weight, at), Extent(points));
    }

    public static DrawnCurve Ellipse(string name, EllipseArc arc)
    {
        var (start, sweep) = (arc.Start.Radians, arc.Sweep.Radians);
        double[] breaks = [.. Enumerable.Range(0, 9).Select(i => i / 8.0)];
        return new DrawnCurve(name, arc.ToCurve(), breaks, at => OnEllipse(arc, start + (sweep * at)), 2.0 * (arc.First.Length + arc.Second.Length));
    }

    /// <summary>Knots 0 and 1 with the multiplicity of a curve without inner knots.</summary>
    public static DrawnCurve Bezier(string name, Point2D[] points, double[]? weights = null) =>
        Spline(name, points.Length - 1, [.. Enumerable.Repeat(0.0, points.Length), .. Enumerable.Repeat(1.0, points.Length)], points, weights);

    /// <summary>Points along the curve, evenly by the parameter between two breaks.</summary>
    public IEnumerable<double> Parameters(int perSmoothPiece)
    {
        for (var i = 0; i + 1 < Breaks.Count; i++)
        {
            for (var step = 0; step <= perSmoothPiece; step++) yield return Breaks[i] + ((Breaks[i + 1] - Breaks[i]) * step / perSmoothPiece);
        }
    }

    /// <summary>Direction of travel (length 1) by differences; NaN where the curve has zero speed.</summary>
    public Vector2D Direction(double parameter)
    {
        var step = (Breaks[^1] - Breaks[0]) * 1e-6;
        var way = At(Math.Min(parameter + step, Breaks[^1])) - At(Math.Max(parameter - step, Breaks[0]));
        return way * (1.0 / way.Length);
    }

    /// <summary>Distance from a point, by a coarse search and then a fine one around every local minimum.</summary>
    public double DistanceFrom(Point2D place)
    {
        var nearest = double.PositiveInfinity;
        for (var i = 0; i + 1 < Breaks.Count; i++)
        {
            var (from, step) = (Breaks[i], (Breaks[i + 1] - Breaks[i]) / CoarseSteps);
            double[] distances = [.. Enumerable.Range(0, CoarseSteps + 1).Select(k => At(from + (k * step)).DistanceTo(place))];
            for (var k = 0; k <= CoarseSteps; k++)
            {
                var (before, after) = (distances[Math.Max(0, k - 1)], distances[Math.Min(CoarseSteps, k + 1)]);
                if (distances[k] <= before && distances[k] <= after) nearest = Math.Min(nearest, Finely(place, from + (Math.Max(0, k - 1) * step), from + (Math.Min(CoarseSteps, k + 1) * step)));
            }
        }

        return nearest;
    }

    /// <summary>A chain of points along the curve, at most a step apart, with chords at most a thousandth of the step from the curve.</summary>
    public List<Point2D> Trace(double from, double to, double step)
    {
        var places = new List<Point2D> { At(from) };
        double[] marks = [from, .. Breaks.Where(mark => mark > from && mark < to), to];
        for (var i = 0; i + 1 < marks.Length; i++)
        {
            for (var part = 0; part < 8; part++) Walk(places, marks[i] + ((marks[i + 1] - marks[i]) * part / 8.0), marks[i] + ((marks[i + 1] - marks[i]) * (part + 1) / 8.0), step, 30);
        }

        return places;
    }

    public override string ToString() => Name;

    private void Walk(List<Point2D> places, double from, double to, double step, int halvings)
    {
        var (start, middle, end) = (At(from), At((from + to) / 2.0), At(to));
        var chord = new LineSegment(start, end);
        if (halvings == 0 || (chord.Length <= step && start.DistanceTo(middle) <= step && chord.DistanceTo(middle) <= 1e-4))
        {
            places.Add(end);
            return;
        }

        Walk(places, from, (from + to) / 2.0, step, halvings - 1);
        Walk(places, (from + to) / 2.0, to, step, halvings - 1);
    }

    /// <summary>Golden section.</summary>
    private double Finely(Point2D place, double low, double high)
    {
        var (a, b) = (low, high);
        for (var i = 0; i < 80; i++)
        {
            var (c, d) = (b - (s_golden * (b - a)), a + (s_golden * (b - a)));
            if (At(c).DistanceTo(place) < At(d).DistanceTo(place)) b = d;
            else a = c;
        }

        return Math.Min(At((a + b) / 2.0).DistanceTo(place), Math.Min(At(low).DistanceTo(place), At(high).DistanceTo(place)));
    }

    private static Point2D OnEllipse(EllipseArc arc, double angle) => new(
        arc.Centre.X + (arc.First.X * Math.Cos(angle)) + (arc.Second.X * Math.Sin(angle)),
        arc.Centre.Y + (arc.First.Y * Math.Cos(angle)) + (arc.Second.Y * Math.Sin(angle)));

    private static Point2D DeBoor(int degree, double[] knots, Point2D[] points, double[] weights, double at)
    {
        var span = degree;
        while (span < points.Length - 1 && at >= knots[span + 1]) span++;
        while (knots[span] == knots[span + 1]) span--;
        var (x, y, w) = (new double[degree + 1], new double[degree + 1], new double[degree + 1]);
        for (var i = 0; i <= degree; i++)
        {
            var point = span - degree + i;
            (x[i], y[i], w[i]) = (points[point].X * weights[point], points[point].Y * weights[point], weights[point]);
        }

        for (var level = 1; level <= degree; level++)
        {
            for (var i = degree; i >= level; i--)
            {
                var (low, high) = (knots[span - degree + i], knots[span + 1 + i - level]);
                var share = (at - low) / (high - low);
                (x[i], y[i], w[i]) = (x[i - 1] + (share * (x[i] - x[i - 1])), y[i - 1] + (share * (y[i] - y[i - 1])), w[i - 1] + (share * (w[i] - w[i - 1])));
            }
        }

        return new Point2D(x[degree] / w[degree], y[degree] / w[degree]);
    }

    private static double Extent(Point2D[] points) => points.Max(point => point.X) - points.Min(point => point.X) + points.Max(point => point.Y) - points.Min(point => point.Y);
}
