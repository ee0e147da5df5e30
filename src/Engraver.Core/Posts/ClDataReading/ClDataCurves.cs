using Engraver.Core.Geometry;

namespace Engraver.Core.Posts.ClDataReading;

/// <summary>Ellipses and splines of a DXF as chords, by their definitions: an ellipse by its two axes, a spline by de Boor's recurrence over its
/// knots.</summary>
internal static class ClDataCurves
{
    /// <summary>Largest distance of a chord from its curve, millimetres.</summary>
    private const double ChordError = 1e-5;

    private const int MaxHalvings = 14;
    private const int FirstParts = 8;

    /// <summary>A larger ellipse parameter is not valid, radians.</summary>
    private const double MaxParameter = 1000.0;

    /// <returns>Null when a number is missing or invalid; its group code is in the numbers.</returns>
    public static IEnumerable<Segment>? Ellipse(GroupNumbers numbers)
    {
        var (centre, major) = (new Point2D(numbers.Single(10), numbers.Single(20)), new Vector2D(numbers.Single(11), numbers.Single(21)));
        var ratio = numbers.Single(40) * numbers.Optional(230, 1.0); // below 0 for an ellipse seen from below, which runs clockwise
        var (start, end) = (numbers.Single(41), numbers.Single(42)); // parameters, radians
        if (!(Math.Abs(ratio) is > 0.0 and <= 1.0)) numbers.Reject(40);
        if (Math.Max(Math.Abs(start), Math.Abs(end)) > MaxParameter) numbers.Reject(41);
        if (numbers.Invalid is not null) return null;
        while (end <= start) end += 2.0 * Math.PI;
        var minor = new Vector2D(-major.Y * ratio, major.X * ratio);
        return Chords(turn => centre + (major * Math.Cos(turn)) + (minor * Math.Sin(turn)), start, end);
    }

    /// <returns>Null when a number is missing or invalid; its group code is in the numbers.</returns>
    public static IEnumerable<Segment>? Spline(GroupNumbers numbers)
    {
        var (degree, knots, xs, ys, weights) = (numbers.Single(71), numbers.All(40), numbers.All(10), numbers.All(20), numbers.All(41));
        if (!((int)degree is >= 1 and <= 25)) numbers.Reject(71);
        if (xs.Length != ys.Length || xs.Length <= (int)degree) numbers.Reject(10);
        if (knots.Length != xs.Length + (int)degree + 1 || knots.Zip(knots.Skip(1)).Any(pair => pair.Second < pair.First)) numbers.Reject(40);
        if (weights.Length != 0 && (weights.Length != xs.Length || weights.Any(weight => !(weight > 0.0)))) numbers.Reject(41);
        return numbers.Invalid is null ? Spans((int)degree, knots, [.. xs.Zip(ys, (x, y) => new Point2D(x, y))], weights) : null;
    }

    private static IEnumerable<Segment> Spans(int degree, double[] knots, Point2D[] points, double[] weights)
    {
        for (var span = degree; span < points.Length; span++)
        {
            if (knots[span + 1] == knots[span]) continue;
            var at = span;
            foreach (var chord in Chords(u => Place(degree, knots, points, weights, at, u), knots[span], knots[span + 1])) yield return chord;
        }
    }

    /// <summary>de Boor's algorithm: the points of a span, interpolated degree by degree.</summary>
    private static Point2D Place(int degree, double[] knots, Point2D[] points, double[] weights, int span, double u)
    {
        var mixed = new (double X, double Y, double W)[degree + 1];
        for (var i = 0; i <= degree; i++)
        {
            var (point, weight) = (points[span - degree + i], weights.Length == 0 ? 1.0 : weights[span - degree + i]);
            mixed[i] = (point.X * weight, point.Y * weight, weight);
        }

        for (var level = 1; level <= degree; level++)
        {
            for (var i = degree; i >= level; i--)
            {
                var (low, high) = (knots[span - degree + i], knots[span + 1 + i - level]);
                var share = high > low ? (u - low) / (high - low) : 0.0;
                mixed[i] = (mixed[i - 1].X + ((mixed[i].X - mixed[i - 1].X) * share), mixed[i - 1].Y + ((mixed[i].Y - mixed[i - 1].Y) * share), mixed[i - 1].W + ((mixed[i].W - mixed[i - 1].W) * share));
            }
        }

        return new Point2D(mixed[degree].X / mixed[degree].W, mixed[degree].Y / mixed[degree].W);
    }

    private static IEnumerable<Segment> Chords(Func<double, Point2D> at, double from, double to)
    {
        for (var i = 0; i < FirstParts; i++)
        {
            var (low, high) = (from + ((to - from) * i / FirstParts), from + ((to - from) * (i + 1) / FirstParts));
            foreach (var chord in Halved(at, low, at(low), high, at(high), MaxHalvings)) yield return chord;
        }
    }

    private static IEnumerable<Segment> Halved(Func<double, Point2D> at, double low, Point2D first, double high, Point2D last, int halvings)
    {
        var chord = Segment.FromLine(first, last);
        var (middle, isNear) = (at((low + high) / 2.0), true);
        foreach (var share in (double[])[0.25, 0.5, 0.75]) isNear = isNear && chord.DistanceTo(at(low + ((high - low) * share))) <= ChordError;
        if (isNear || halvings == 0) return first == last ? [] : [chord];
        return Halved(at, low, first, (low + high) / 2.0, middle, halvings - 1).Concat(Halved(at, (low + high) / 2.0, middle, high, last, halvings - 1));
    }
}
