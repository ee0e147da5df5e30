using Engraver.Core.Geometry;

namespace Engraver.Core.Verification;

/// <summary>Which part of a nearly straight piece of a curve lies within reach of a cut along a line or an arc: between the feet of the cut's ends, as far as the cut stays near.</summary>
/// <remarks>A cut that only crosses the piece covers nothing of it: what it would cover is shorter than any gap that counts.</remarks>
internal static class CutNearCurve
{
    private const int Places = 8;
    private const int Halvings = 30;

    public static void Cover(in Segment piece, in Segment cut, double reach, CoveredParts covered)
    {
        var span = piece.Curve.Spans[0];
        var (first, last) = (FootOf.Place(span, cut.Start), FootOf.Place(span, cut.End));
        var (from, to) = (Math.Min(first, last), Math.Max(first, last));
        Widen(span, reach, ref from, ref to);
        var isShort = cut.Kind == SegmentKind.Line && cut.Length < 4.0 * reach;
        var places = isShort ? 2 : Places;
        var (before, wasNear) = (from, IsNear(span, from, cut, reach));
        var start = from;
        for (var i = 1; i <= places; i++)
        {
            var at = from + ((to - from) * i / places);
            var isNear = IsNear(span, at, cut, reach);
            if (isNear && !wasNear) start = Border(span, at, before, cut, reach);
            if (wasNear && !isNear) covered.Add(start, Border(span, before, at, cut, reach));
            (before, wasNear) = (at, isNear);
        }

        if (wasNear) covered.Add(start, to);
    }

    /// <summary>The piece reaches beyond the feet by up to the reach.</summary>
    private static void Widen(BezierSpan span, double reach, ref double from, ref double to)
    {
        span.Evaluate(from, out var atFrom);
        span.Evaluate(to, out var atTo);
        if (atFrom.Length > 0.0) from = Math.Max(0.0, from - (reach / atFrom.Length));
        if (atTo.Length > 0.0) to = Math.Min(1.0, to + (reach / atTo.Length));
    }

    private static bool IsNear(BezierSpan span, double parameter, in Segment cut, double reach) => cut.DistanceTo(span.PointAt(parameter)) <= reach;

    /// <summary>The last parameter within reach on the way from one that is to one that is not.</summary>
    private static double Border(BezierSpan span, double near, double far, in Segment cut, double reach)
    {
        for (var i = 0; i < Halvings; i++)
        {
            var middle = (near + far) / 2.0;
            if (IsNear(span, middle, cut, reach)) near = middle;
            else far = middle;
        }

        return near;
    }
}
