using Engraver.Core.Geometry;

namespace Engraver.Core.Verification;

/// <summary>The part of a nearly straight piece of a curve within reach of a cut, or the part of any segment within reach of a cut along such a piece: between
/// the feet of the cut's ends, as far as the cut stays near.</summary>
/// <remarks>A cut that only crosses the piece covers no part of it: the covered part would be shorter than any relevant gap.</remarks>
internal static class CurveCutCover
{
    private const int Places = 8;
    private const int Halvings = 30;

    /// <summary>Above this sweep in degrees, the ends of an arc do not determine which segments are next to it.</summary>
    private const double Bent = 60.0;

    public static void Cover(in Segment piece, in Segment cut, double reach, CoveredParts covered)
    {
        var (first, last) = (PerpendicularFoot.Place(piece, cut.Start, double.NaN).Foot, PerpendicularFoot.Place(piece, cut.End, double.NaN).Foot);
        var (from, to) = (Math.Min(first, last), Math.Max(first, last));
        Widen(piece, reach, ref from, ref to);
        var isBent = cut.Kind is SegmentKind.Arc or SegmentKind.Circle && Math.Abs(cut.Arc.Sweep.Degrees) > Bent;
        ReadOnlySpan<double> marks = isBent ? [0.0, from, to, 1.0] : [from, to];
        var isShort = cut.Kind == SegmentKind.Line && cut.Length < 4.0 * reach;
        var places = isShort ? 2 : Places;
        var (before, wasNear) = (marks[0], IsNear(piece, marks[0], cut, reach));
        var start = before;
        for (var i = 1; i <= places * (marks.Length - 1); i++)
        {
            var (mark, share) = ((i - 1) / places, (((i - 1) % places) + 1.0) / places);
            var at = marks[mark] + ((marks[mark + 1] - marks[mark]) * share);
            var isNear = IsNear(piece, at, cut, reach);
            if (isNear && !wasNear) start = Border(piece, at, before, cut, reach);
            if (wasNear && !isNear) covered.Add(start, Border(piece, before, at, cut, reach));
            (before, wasNear) = (at, isNear);
        }

        if (wasNear) covered.Add(start, marks[^1]);
    }

    /// <summary>The piece reaches beyond the feet by up to the reach.</summary>
    private static void Widen(in Segment piece, double reach, ref double from, ref double to)
    {
        var (atFrom, atTo) = (SpeedAt(piece, from), SpeedAt(piece, to));
        if (atFrom > 0.0) from = Math.Max(0.0, from - (reach / atFrom));
        if (atTo > 0.0) to = Math.Min(1.0, to + (reach / atTo));
    }

    private static double SpeedAt(in Segment piece, double parameter)
    {
        if (!piece.IsFreeCurve) return piece.Length;
        piece.Curve.Spans[0].Evaluate(parameter, out var derivative);
        return derivative.Length;
    }

    private static bool IsNear(in Segment piece, double parameter, in Segment cut, double reach) => cut.DistanceTo(piece.PointAt(parameter)) <= reach;

    /// <summary>The last parameter within reach between a parameter within reach and one that is not.</summary>
    private static double Border(in Segment piece, double near, double far, in Segment cut, double reach)
    {
        for (var i = 0; i < Halvings; i++)
        {
            var middle = (near + far) / 2.0;
            if (IsNear(piece, middle, cut, reach)) near = middle;
            else far = middle;
        }

        return near;
    }
}
