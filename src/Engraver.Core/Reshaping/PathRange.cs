using Engraver.Core.Geometry;

namespace Engraver.Core.Reshaping;

/// <summary>The remaining or removed piece of one part: from one fraction to another; below 0 and above 1 it is lengthened, or for a closed part continues over
/// its seam.</summary>
/// <param name="Part">Index of the part, from 0.</param>
/// <param name="Start">The place at <paramref name="From"/>.</param>
/// <param name="End">The place at <paramref name="To"/>.</param>
public readonly record struct PathRange(int Part, double From, double To, Point2D Start, Point2D End)
{
    /// <summary>The whole part.</summary>
    public static PathRange Whole(int part, Segment segment) => new(part, 0.0, 1.0, segment.Start, segment.End);

    /// <summary>The piece as a segment in plan.</summary>
    /// <param name="part">The whole part.</param>
    public Segment Of(Segment part)
    {
        if (From == 0.0 && To == 1.0) return part;
        if (part.Kind == SegmentKind.Line) return Segment.FromLine(Start, End);
        if (part.IsFreeCurve) return Segment.FromCurve(To <= 1.0 ? CurvePart.Between(part.Curve, From, To) : CurvePart.Joined(CurvePart.Between(part.Curve, From, 1.0), CurvePart.Between(part.Curve, 0.0, To - 1.0)));
        var arc = part.Arc;
        return Segment.FromArc(arc with { Start = arc.Start + (arc.Sweep * From), Sweep = arc.Sweep * (To - From) });
    }
}
