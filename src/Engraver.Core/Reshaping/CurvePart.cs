using Engraver.Core.Geometry;

namespace Engraver.Core.Reshaping;

/// <summary>Parts of an ellipse or spline, exact: a part of a rational Bezier span is also a rational Bezier span.</summary>
public static class CurvePart
{
    /// <summary>A part of a span that is shorter than this, as a fraction of its parameter, is due to rounding: the cut is at the joint of two spans.</summary>
    private const double OnJoint = 1e-10;

    /// <summary>The part between two fractions of the parameter, 0 to 1, the first below the second.</summary>
    public static RationalCurve Between(RationalCurve curve, double from, double to)
    {
        ArgumentNullException.ThrowIfNull(curve);
        var count = curve.Spans.Length;
        var (first, last) = (Rounded(from * count), Rounded(to * count));
        var spans = new List<BezierSpan>();
        for (var span = 0; span < count; span++)
        {
            var (begin, end) = (Math.Clamp(first - span, 0.0, 1.0), Math.Clamp(last - span, 0.0, 1.0));
            if (end > begin) spans.Add(curve.Spans[span].Part(begin, end));
        }

        return new RationalCurve(curve.Kind, [.. spans]);
    }

    private static double Rounded(double place) => Math.Abs(place - Math.Round(place)) < OnJoint ? Math.Round(place) : place;

    /// <summary>Two parts of a closed curve, joined over its seam.</summary>
    public static RationalCurve Joined(RationalCurve first, RationalCurve second)
    {
        ArgumentNullException.ThrowIfNull(first);
        ArgumentNullException.ThrowIfNull(second);
        return new RationalCurve(first.Kind, [.. first.Spans, .. second.Spans]);
    }
}
