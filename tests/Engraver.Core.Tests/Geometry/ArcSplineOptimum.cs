using Engraver.Core.Geometry;

namespace Engraver.Core.Tests.Geometry;

/// <summary>The smallest number of lines and arcs that can follow a curve: dynamic programming over 256 knots of each smooth run. Independent of the fit that
/// it judges.</summary>
/// <remarks>Two knots are connected by one arc (or line) whose tangents are those of the curve at both, or by two arcs of the family that starts and ends in
/// the curve's directions. Their distance is sampled, so the result may be too small.</remarks>
internal sealed class ArcSplineOptimum
{
    private const int Knots = 256;
    private const int SamplesPerKnot = 4;
    private const int HopelessAfter = 12;
    private const double SameDirection = 1e-4;

    /// <summary>First tangent length divided by that of the pair with equal lengths.</summary>
    private static readonly double[] Family = [1.0, 0.8, 1.25, 0.6, 1.7, 0.4, 2.5, 0.2, 5.0];

    private readonly Point2D[] _samples;
    private readonly Vector2D[] _tangents;
    private readonly double _tolerance;

    private ArcSplineOptimum(Point2D[] samples, Vector2D[] tangents, double tolerance) => (_samples, _tangents, _tolerance) = (samples, tangents, tolerance);

    /// <summary>Smallest number of pieces; null if 256 knots are too few to follow the curve.</summary>
    public static int? Pieces(RationalCurve curve, double tolerance)
    {
        var sum = 0;
        for (int first = 0, end; first < curve.Spans.Length; first = end)
        {
            for (end = first + 1; end < curve.Spans.Length && IsSmooth(curve.Spans[end - 1], curve.Spans[end]);) end++;
            if (Of(curve.Spans[first..end].ToArray(), tolerance).FindFewest() is not { } pieces) return null;
            sum += pieces;
        }

        return sum;
    }

    private static bool IsSmooth(BezierSpan before, BezierSpan after) =>
        before.EndTangent.Dot(after.StartTangent) > 0.0 && Math.Abs(before.EndTangent.Cross(after.StartTangent)) < 1e-3;

    private static ArcSplineOptimum Of(BezierSpan[] spans, double tolerance)
    {
        var curve = new RationalCurve(SegmentKind.Spline, spans);
        double[] places = [.. Enumerable.Range(0, (Knots * SamplesPerKnot) + 1).Select(i => (double)i / (Knots * SamplesPerKnot))];
        return new ArcSplineOptimum([.. places.Select(curve.PointAt)], [.. places.Where((_, i) => i % SamplesPerKnot == 0).Select(curve.TangentAt)], tolerance);
    }

    private int? FindFewest()
    {
        var fewest = new int?[Knots + 1];
        fewest[0] = 0;
        for (var from = 0; from < Knots; from++)
        {
            if (fewest[from] is not { } soFar) continue;
            for (int to = from + 1, failures = 0; to <= Knots && failures < HopelessAfter; to++)
            {
                var pieces = IsOneArc(from, to) ? 1 : AreTwoArcs(from, to) ? 2 : 0;
                failures = pieces == 0 ? failures + 1 : 0;
                if (pieces > 0) fewest[to] = Math.Min(fewest[to] ?? int.MaxValue, soFar + pieces);
            }
        }

        return fewest[Knots];
    }

    private bool IsOneArc(int from, int to)
    {
        var (start, end, tangent) = (Place(from), Place(to), _tangents[from]);
        var chord = end - start;
        var leaving = ((chord * (2.0 * tangent.Dot(chord))) * (1.0 / chord.LengthSquared)) - tangent;
        return (leaving - _tangents[to]).Length <= SameDirection && tangent.Dot(chord) > 0.0 && IsNear(from * SamplesPerKnot, to * SamplesPerKnot, start, tangent, end);
    }

    private bool AreTwoArcs(int from, int to)
    {
        var (start, leaving, end, arriving) = (Place(from), _tangents[from], Place(to), _tangents[to]);
        var chord = end - start;
        if (!(chord.Dot(leaving) > 0.0) || !(chord.Dot(arriving) > 0.0)) return false;
        var spread = 1.0 - leaving.Dot(arriving);
        var along = chord.Dot(leaving + arriving);
        var equal = chord.LengthSquared / (along + Math.Sqrt((along * along) + (2.0 * spread * chord.LengthSquared)));
        foreach (var part in Family)
        {
            var first = equal * part;
            var second = (chord.LengthSquared - (2.0 * first * chord.Dot(leaving))) / ((2.0 * chord.Dot(arriving)) + (2.0 * first * spread));
            if (!(second > 0.0)) continue;
            var joint = start + ((((leaving * first) * second) + ((chord - (arriving * second)) * first)) * (1.0 / (first + second)));
            var along2 = (chord - (arriving * second)) - (leaving * first);
            if (IsNearBoth(from, to, joint, along2 * (1.0 / along2.Length))) return true;
        }

        return false;
    }

    private bool IsNearBoth(int from, int to, Point2D joint, Vector2D tangent)
    {
        var (low, high) = (from * SamplesPerKnot, to * SamplesPerKnot);
        if (!((joint - Place(from)).Dot(_tangents[from]) > 0.0) || !((Place(to) - joint).Dot(_tangents[to]) > 0.0)) return false;
        if (!((joint - Place(from)).Dot(tangent) > 0.0) || !((Place(to) - joint).Dot(tangent) > 0.0)) return false;
        var middle = low;
        while (middle <= high && (_samples[middle] - joint).Dot(tangent) < 0.0) middle++;
        return IsNear(low, middle - 1, joint, -tangent, Place(from)) && IsNear(middle, high, joint, tangent, Place(to));
    }

    /// <summary>Distance of samples from the circle (or line) through two points with a direction at the first.</summary>
    private bool IsNear(int low, int high, Point2D start, Vector2D tangent, Point2D end)
    {
        var chord = end - start;
        var curvature = 2.0 * tangent.Cross(chord) / chord.LengthSquared;
        for (var i = low; i <= high; i++)
        {
            var way = _samples[i] - start;
            var d = (curvature * way.LengthSquared) - (2.0 * tangent.Cross(way));
            if (Math.Abs(d) > _tolerance * (2.0 + (Math.Sign(d) * curvature * _tolerance))) return false;
        }

        return true;
    }

    private Point2D Place(int knot) => _samples[knot * SamplesPerKnot];
}
