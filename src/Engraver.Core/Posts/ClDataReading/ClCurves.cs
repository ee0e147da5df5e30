using Engraver.Core.Geometry;

namespace Engraver.Core.Posts.ClDataReading;

/// <summary>Ellipses and splines of a DXF as chords, by their definitions: an ellipse by its two axes, a spline by de Boor's recurrence over its
/// knots.</summary>
internal static class ClCurves
{
    /// <summary>Largest distance of a chord from its curve, millimetres.</summary>
    private const double ChordError = 1e-5;

    private const int MostHalvings = 14;
    private const int FirstParts = 8;

    /// <summary>A larger ellipse parameter is not valid, radians.</summary>
    private const double MostParameter = 1000.0;

    /// <param name="ratio">Shorter over longer axis; below 0 for an ellipse seen from below, which runs clockwise.</param>
    /// <param name="start">Start parameter, radians.</param>
    /// <param name="end">End parameter, radians.</param>
    public static IEnumerable<Segment> Ellipse(Point2D centre, Vector2D major, double ratio, double start, double end)
    {
        if (!(Math.Abs(ratio) is > 0.0 and <= 1.0)) throw new FormatException("40");
        if (Math.Max(Math.Abs(start), Math.Abs(end)) > MostParameter) throw new FormatException("41");
        while (end <= start) end += 2.0 * Math.PI;
        var minor = new Vector2D(-major.Y * ratio, major.X * ratio);
        return Chords(turn => centre + (major * Math.Cos(turn)) + (minor * Math.Sin(turn)), start, end);
    }

    /// <param name="weights">One for each point, or none.</param>
    /// <param name="arePairs">True when there are as many x as y values.</param>
    public static IEnumerable<Segment> Spline(int degree, double[] knots, Point2D[] points, double[] weights, bool arePairs)
    {
        if (degree is < 1 or > 25) throw new FormatException("71");
        if (!arePairs || points.Length <= degree) throw new FormatException("10");
        if (knots.Length != points.Length + degree + 1 || knots.Zip(knots.Skip(1)).Any(pair => pair.Second < pair.First)) throw new FormatException("40");
        if (weights.Length != 0 && (weights.Length != points.Length || weights.Any(weight => !(weight > 0.0)))) throw new FormatException("41");
        return Spans(degree, knots, points, weights);
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
            foreach (var chord in Halved(at, low, at(low), high, at(high), MostHalvings)) yield return chord;
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
