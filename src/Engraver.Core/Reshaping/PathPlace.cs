using Engraver.Core.Geometry;

namespace Engraver.Core.Reshaping;

/// <summary>A place on an object of one or several parts.</summary>
/// <param name="Part">Index of the part, from 0.</param>
/// <param name="Fraction">Fraction of a line's length, an arc's sweep or a curve's parameter: 0 is its start, 1 its end; below 0 and above 1 the part is
/// lengthened.</param>
/// <param name="At">The exact place, more precise than the fraction.</param>
public readonly record struct PathPlace(int Part, double Fraction, Point2D At)
{
    /// <summary>Position number that increases along the object.</summary>
    public double Position => Part + Fraction;

    /// <summary>The place of a segment that is nearest to a point.</summary>
    /// <param name="part">Index of the segment as a part.</param>
    public static PathPlace Nearest(int part, Segment segment, Point2D point)
    {
        var fraction = segment.Kind switch
        {
            SegmentKind.Line => Math.Clamp(FractionOf(segment, point), 0.0, 1.0),
            SegmentKind.Arc or SegmentKind.Circle => OnArc(segment, point),
            _ => OnCurve(segment.Curve, point),
        };
        return new PathPlace(part, fraction, segment.PointAt(fraction));
    }

    /// <summary>The fraction at which a line, an arc or the circle under it passes a point on it. For an arc, the turn nearer to the arc: from half
    /// the gap before its start to half the gap after its end.</summary>
    public static double FractionOf(Segment segment, Point2D point)
    {
        if (segment.Kind == SegmentKind.Line)
        {
            var along = segment.End - segment.Start;
            return along.LengthSquared == 0.0 ? 0.0 : (point - segment.Start).Dot(along) / along.LengthSquared;
        }

        if (segment.IsFreeCurve) return OnCurve(segment.Curve, point);
        var (arc, sweep) = (segment.Arc, segment.Arc.Sweep.Abs().Degrees);
        var direction = (point - arc.Centre).Direction;
        var ahead = (arc.Sweep.Degrees >= 0.0 ? direction - arc.Start : arc.Start - direction).Positive().Degrees;
        if (ahead > sweep + ((360.0 - sweep) / 2.0)) ahead -= 360.0;
        return ahead / sweep;
    }

    private static double OnArc(Segment segment, Point2D point)
    {
        var fraction = FractionOf(segment, point);
        if (fraction is >= 0.0 and <= 1.0) return fraction;
        return segment.Start.DistanceTo(point) <= segment.End.DistanceTo(point) ? 0.0 : 1.0;
    }

    /// <summary>Searches in steps, then halves between the neighbours of the best step: the curve approaches before the nearest place and recedes after
    /// it.</summary>
    private static double OnCurve(RationalCurve curve, Point2D point)
    {
        const int Steps = 64;
        const int Halvings = 60;
        var count = Steps * curve.Spans.Length;
        var best = Enumerable.Range(0, count + 1).MinBy(step => curve.PointAt((double)step / count).DistanceTo(point));
        if (best % count == 0 && curve.IsClosed) best = Leaving(0.0) > 0.0 ? count : 0; // at the seam of a closed curve: selects the side
        var (from, to) = (Math.Max(0.0, (best - 1.0) / count), Math.Min(1.0, (best + 1.0) / count));
        if (Leaving(from) >= 0.0) return from;
        if (Leaving(to) <= 0.0) return to;
        for (var i = 0; i < Halvings; i++)
        {
            var middle = (from + to) / 2.0;
            if (Leaving(middle) > 0.0) to = middle;
            else from = middle;
        }

        return (from + to) / 2.0;

        double Leaving(double fraction) => (curve.PointAt(fraction) - point).Dot(curve.TangentAt(fraction));
    }
}
