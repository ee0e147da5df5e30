using Engraver.Core.Geometry;

namespace Engraver.Core.Offsets;

/// <summary>A closed curve that is not wider than its tolerance, for example an ellipse of ratio 1e-9: a line there and back, which encloses no area.</summary>
internal static class FlatCurve
{
    /// <summary>Part of the tolerance of a curve's arcs up to which half its width counts as zero.</summary>
    private const double WidthShare = 0.1;

    private const int FewSamples = 8;
    private const int ManySamples = 512;

    /// <summary>The ends of the lines that represent the curve, the first and the last being its start, and its direction of rotation (1 counter-clockwise, -1
    /// clockwise); null for a curve that has a width.</summary>
    /// <param name="curve">Closed.</param>
    /// <param name="maxErrorMm">Largest distance of the arcs that would approximate it.</param>
    public static (IReadOnlyList<Point2D> Places, int Turn)? From(RationalCurve curve, double maxErrorMm)
    {
        var width = WidthShare * maxErrorMm;
        if (!IsThin(curve, FewSamples, width) || !IsThin(curve, ManySamples, width)) return null;
        var far = FarthestFrom(curve, curve.Start);
        var back = FarthestFrom(curve, curve.PointAt(far));
        List<Point2D> places = [curve.Start];
        foreach (var turn in new[] { far, back }.Order())
        {
            if (!curve.PointAt(turn).IsNear(curve.Start, width)) places.Add(curve.PointAt(turn));
        }

        var samples = Samples(curve, ManySamples).Select(place => place - curve.Start).ToArray();
        return ([.. places, curve.Start], Math.Sign(samples.Zip(samples.Skip(1)).Sum(pair => pair.First.Cross(pair.Second))));
    }

    private static IEnumerable<Point2D> Samples(RationalCurve curve, int count) => Enumerable.Range(0, count + 1).Select(i => curve.PointAt((double)i / count));

    private static bool IsThin(RationalCurve curve, int count, double width)
    {
        var places = Samples(curve, count).ToArray();
        var far = places.MaxBy(place => (place - places[0]).LengthSquared);
        var along = far - places[0];
        return Array.TrueForAll(places, place => Math.Abs(along.Cross(place - places[0])) <= width * along.Length);
    }

    /// <summary>Fraction of the curve at which it is farthest from a point: the best sample, refined by thirds of the interval around it until nothing
    /// changes.</summary>
    private static double FarthestFrom(RationalCurve curve, Point2D place)
    {
        double Away(double fraction) => (curve.PointAt(Math.Clamp(fraction, 0.0, 1.0)) - place).LengthSquared;
        var best = Enumerable.Range(0, ManySamples + 1).MaxBy(i => Away((double)i / ManySamples)) / (double)ManySamples;
        var (low, high) = (Math.Max(0.0, best - (1.0 / ManySamples)), Math.Min(1.0, best + (1.0 / ManySamples)));
        while (high - low > 1e-12)
        {
            var (first, second) = (low + ((high - low) / 3.0), high - ((high - low) / 3.0));
            if (Away(first) < Away(second)) low = first;
            else high = second;
        }

        return (low + high) / 2.0;
    }
}
