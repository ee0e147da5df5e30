using Engraver.Core.Geometry;
using Engraver.Core.Sequencing;
using Engraver.Core.Verification;

namespace Engraver.Core.Operations;

/// <summary>Turns a closed stroke so that it begins where its operation states.</summary>
internal static class StrokeStart
{
    /// <summary>A contour turns by at least this angle at a corner, degrees; less is a polygon that stands for a curve.</summary>
    private const double LeastTurn = 20.0;

    /// <summary>Corners that differ by less are equally sharp, degrees: the first of them is taken.</summary>
    private const double SameTurn = 0.01;

    /// <summary>Rounding of lengths, mm.</summary>
    private const double Rounding = 1e-6;

    /// <summary>Begins in the middle of the longest or the highest side, or at the sharpest corner.</summary>
    /// <param name="moves">Lines and arcs of a closed stroke.</param>
    /// <param name="clearance">Distance of a place from the nearest drawn contour.</param>
    /// <param name="offset">Distance of the stroke from its contour, mm.</param>
    /// <returns>The moves unchanged for <see cref="StartRule.Nearest"/>; null when the stroke has no corner.</returns>
    public static IReadOnlyList<StrokeMove>? By(StartRule rule, IReadOnlyList<StrokeMove> moves, Func<Point2D, double> clearance, double offset)
    {
        var indices = Enumerable.Range(0, moves.Count);
        switch (rule)
        {
            case StartRule.Longest:
                return Turned(moves, indices.MaxBy(index => moves[index].Segment.Length), 0.5);
            case StartRule.Top:
                var highest = indices.MaxBy(index => moves[index].Segment.PointAt(TopOf(moves[index].Segment)).Y);
                return Turned(moves, highest, TopOf(moves[highest].Segment));
            case StartRule.Corner:
                return CornerOf(moves, clearance, offset) is var (index, fraction) ? Turned(moves, index, fraction) : null;
            default:
                return moves;
        }
    }

    /// <summary>Begins at the point of a closed stroke that is nearest to a place.</summary>
    public static IReadOnlyList<StrokeMove> Near(Point2D place, IReadOnlyList<StrokeMove> moves)
    {
        var nearest = Enumerable.Range(0, moves.Count).MinBy(index => moves[index].Segment.DistanceTo(place));
        var segment = moves[nearest].Segment;
        var fraction = PerpendicularFoot.Place(segment, place, double.NaN).Foot;
        if (fraction * segment.Length <= Rounding) fraction = 0.0;
        if ((1.0 - fraction) * segment.Length <= Rounding) fraction = 1.0;
        return Turned(moves, nearest, fraction);
    }

    /// <summary>Begins at a fraction of a move.</summary>
    private static IReadOnlyList<StrokeMove> Turned(IReadOnlyList<StrokeMove> moves, int index, double fraction)
    {
        var move = moves[index];
        if (fraction <= 0.0) return [.. moves.Skip(index), .. moves.Take(index)];
        if (fraction >= 1.0) return [.. moves.Skip(index + 1), .. moves.Take(index + 1)];
        return [Part(fraction, 1.0), .. moves.Skip(index + 1), .. moves.Take(index), Part(0.0, fraction)];

        StrokeMove Part(double from, double to) => move with { Segment = SegmentPart.Of(move.Segment, from, to) };
    }

    /// <summary>The sharpest corner: a joint, or the middle of the arc around a corner of the contour.</summary>
    private static (int Index, double Fraction)? CornerOf(IReadOnlyList<StrokeMove> moves, Func<Point2D, double> clearance, double offset)
    {
        var (sharpest, found) = (LeastTurn, ((int, double)?)null);
        for (var index = 0; index < moves.Count; index++)
        {
            var segment = moves[index].Segment;
            var isAround = segment.Kind == SegmentKind.Arc && Math.Abs(segment.Arc.Radius - offset) <= Rounding * (1.0 + offset) && clearance(segment.Arc.Centre) <= Rounding;
            Offer(Math.Abs(moves[(index + moves.Count - 1) % moves.Count].Segment.EndTangent.TurnTo(segment.StartTangent).Degrees), index, 0.0);
            if (isAround) Offer(Math.Abs(segment.Arc.Sweep.Degrees), index, 0.5);
        }

        return found;

        void Offer(double turn, int index, double fraction)
        {
            if (turn > sharpest + SameTurn) (sharpest, found) = (turn, (index, fraction));
        }
    }

    /// <summary>The fraction at the highest point of an arc, if it is within the arc; otherwise the middle.</summary>
    private static double TopOf(in Segment segment)
    {
        if (segment.Kind == SegmentKind.Line) return 0.5;
        var (arc, up) = (segment.Arc, Angle.FromDegrees(90.0));
        var ahead = arc.Sweep.Degrees >= 0.0 ? (up - arc.Start).Positive().Degrees : (arc.Start - up).Positive().Degrees;
        return ahead / Math.Abs(arc.Sweep.Degrees) is > 0.01 and < 0.99 and var fraction ? fraction : 0.5;
    }
}
