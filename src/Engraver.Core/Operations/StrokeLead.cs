using Engraver.Core.Geometry;
using Engraver.Core.Sequencing;

namespace Engraver.Core.Operations;

/// <summary>Leads beside the contours in the waste.</summary>
/// <param name="clearance">Distance of a place from the nearest part.</param>
/// <param name="radius">The smallest allowed distance.</param>
/// <param name="rounding">A lead may be nearer by this, mm.</param>
internal sealed class StrokeLead(Func<Point2D, double> clearance, double radius, double rounding)
{
    /// <summary>A lead that is as short as this is not useful, mm.</summary>
    private const double ShortestLead = 0.05;

    /// <summary>The longest move to the start of a stroke with enough room, halved until it has; null without room.</summary>
    public StrokeMove? Into(LeadMove lead, in StrokeMove first) =>
        Longest(lead, first.Segment.Start, first.Segment.StartTangent) is { } move ? first with { Segment = move, Role = StrokeRole.Lead, EndZ = first.StartZ } : null;

    /// <summary>The longest move away from the end of a stroke.</summary>
    public StrokeMove? OutOf(LeadMove lead, in StrokeMove last) =>
        Longest(lead, last.Segment.End, last.Segment.EndTangent * -1.0) is { } move ? last with { Segment = move.Reversed(), Role = StrokeRole.Lead, StartZ = last.EndZ } : null;

    /// <summary>Stated length of a lead that was made: of a line, or the radius of an arc.</summary>
    public static double LengthOf(in Segment lead) => lead.Kind == SegmentKind.Line ? lead.Length : lead.Arc.Radius;

    /// <param name="tangent">Direction in which the contour is entered.</param>
    private Segment? Longest(LeadMove lead, Point2D start, Vector2D tangent)
    {
        var left = new Vector2D(-tangent.Y, tangent.X);
        var side = clearance(start + (left * ShortestLead)) >= clearance(start - (left * ShortestLead)) ? left : left * -1.0;
        for (var length = lead.Length; length >= ShortestLead; length /= 2.0)
        {
            var from = lead.Direction == LeadDirection.Tangential ? tangent * -1.0 : side;
            var move = lead.Shape == LeadShape.Line ? Segment.FromLine(start + (from * length), start) : QuarterTo(start, tangent, side, length);
            if (HasRoom(move)) return move;
        }

        return null;
    }

    /// <summary>Follows the lead by steps in which nothing can come nearer than the radius, at least a hundredth of it.</summary>
    private bool HasRoom(in Segment lead)
    {
        var (along, shortest) = (0.0, Math.Max(1e-4, 0.01 * radius));
        while (true)
        {
            var distance = clearance(lead.PointAt(Math.Min(1.0, along / lead.Length)));
            if (distance < radius - rounding) return false;
            if (along >= lead.Length) return true;
            along += Math.Max(shortest, distance - radius);
        }
    }

    private static Segment QuarterTo(Point2D start, Vector2D tangent, Vector2D side, double radius)
    {
        var centre = start + (side * radius);
        var isLeft = (tangent.X * side.Y) - (tangent.Y * side.X) > 0.0;
        var from = centre - (tangent * radius);
        var sweep = Angle.FromDegrees(isLeft ? 90.0 : -90.0);
        return Segment.FromArc(new ArcSegment(centre, radius, (from - centre).Direction, sweep), from, start);
    }
}
