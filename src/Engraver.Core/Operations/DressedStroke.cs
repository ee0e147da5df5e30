using Engraver.Core.EntityTables;
using Engraver.Core.Geometry;
using Engraver.Core.Sequencing;
using Engraver.Core.Verification;

namespace Engraver.Core.Operations;

/// <summary>A closed stroke of a profile while it gets its depth, its tabs and its leads.</summary>
/// <param name="moves">Lines and arcs in order and direction, in plan.</param>
internal sealed class DressedStroke(IReadOnlyList<StrokeMove> moves)
{
    /// <summary>Ends of a lead that is as short as this are not useful, mm.</summary>
    private const double ShortestLead = 0.05;

    /// <summary>Rounding of distances, mm.</summary>
    private const double Rounding = 1e-6;

    private List<StrokeMove> _moves = [.. moves];

    public IReadOnlyList<StrokeMove> Moves => _moves;

    /// <summary>Raises the tool over tabs.</summary>
    /// <param name="places">Distances along the stroke of the middles of the tabs, in order; each tab is within one move.</param>
    /// <param name="span">Length of path on which the tool is up: width of the tab and diameter of the tool.</param>
    /// <param name="depth">Depth of the pass, below the tabs.</param>
    /// <param name="tabDepth">Depth of the top of the tabs.</param>
    public void AddTabs(IReadOnlyList<double> places, double span, double depth, double tabDepth)
    {
        if (depth <= tabDepth) return;
        var (dressed, along) = (new List<StrokeMove>(), 0.0);
        foreach (var move in _moves)
        {
            var (length, from) = (move.Segment.Length, 0.0);
            foreach (var place in places.Where(place => place > along && place < along + length))
            {
                var (up, down) = ((place - along - (span / 2.0)) / length, (place - along + (span / 2.0)) / length);
                Add(move, from, up, StrokeRole.Cut, -depth);
                var (left, right) = (move.Segment.PointAt(up), move.Segment.PointAt(down));
                dressed.Add(new StrokeMove(Segment.FromLine(left, left), move.EntityIndex, -depth, -tabDepth) { Role = StrokeRole.Tab });
                Add(move, up, down, StrokeRole.Tab, -tabDepth);
                dressed.Add(new StrokeMove(Segment.FromLine(right, right), move.EntityIndex, -tabDepth, -depth) { Role = StrokeRole.Tab });
                from = down;
            }

            Add(move, from, 1.0, StrokeRole.Cut, -depth);
            along += length;
        }

        _moves = dressed;

        void Add(in StrokeMove move, double from, double to, StrokeRole role, double z) =>
            dressed.Add(move with { Segment = SegmentPart.Of(move.Segment, from, to), StartZ = z, EndZ = z, Role = role });
    }

    /// <summary>Sets the height of every move.</summary>
    public void SetDepth(double depth) => _moves = [.. _moves.Select(move => move with { StartZ = -depth, EndZ = -depth })];

    /// <summary>Leads to the start and away from the end, beside the contour in the waste.</summary>
    /// <param name="clearance">Distance of a place from the nearest part.</param>
    /// <param name="radius">The smallest allowed distance.</param>
    /// <returns>The lengths of the leads, shortened where there is not enough room; 0 for none.</returns>
    public (double In, double Out) AddLeads(LeadMove? into, LeadMove? outOf, Func<Point2D, double> clearance, double radius)
    {
        var (first, last) = (_moves[0], _moves[^1]);
        var (start, tangent) = (first.Segment.Start, first.Segment.StartTangent);
        var left = new Vector2D(-tangent.Y, tangent.X);
        var side = clearance(start + (left * ShortestLead)) >= clearance(start - (left * ShortestLead)) ? left : left * -1.0;
        var (lengthIn, lengthOut) = (0.0, 0.0);
        if (into is not null && Longest(into, start, tangent, side, clearance, radius) is var (moveIn, goodIn))
        {
            _moves.Insert(0, first with { Segment = moveIn, Role = StrokeRole.Lead, EndZ = first.StartZ });
            lengthIn = goodIn;
        }

        if (outOf is not null && Longest(outOf, start, tangent * -1.0, side, clearance, radius) is var (moveOut, goodOut))
        {
            _moves.Add(last with { Segment = moveOut.Reversed(), Role = StrokeRole.Lead, StartZ = last.EndZ });
            lengthOut = goodOut;
        }

        return (lengthIn, lengthOut);
    }

    /// <summary>The longest lead with enough room, halved until it has.</summary>
    /// <param name="tangent">Direction in which the contour is entered.</param>
    private static (Segment Lead, double Length)? Longest(LeadMove lead, Point2D start, Vector2D tangent, Vector2D side, Func<Point2D, double> clearance, double radius)
    {
        for (var length = lead.Length; length >= ShortestLead; length /= 2.0)
        {
            var move = lead.Shape == LeadShape.Line ? Segment.FromLine(start + (side * length), start) : QuarterTo(start, tangent, side, length);
            if (HasRoom(move, clearance, radius)) return (move, length);
        }

        return null;
    }

    /// <summary>Follows the lead by steps in which nothing can come nearer than the radius, at least a hundredth of it.</summary>
    private static bool HasRoom(in Segment lead, Func<Point2D, double> clearance, double radius)
    {
        var (along, shortest) = (0.0, Math.Max(1e-4, 0.01 * radius));
        while (true)
        {
            var distance = clearance(lead.PointAt(Math.Min(1.0, along / lead.Length)));
            if (distance < radius - Rounding) return false;
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
