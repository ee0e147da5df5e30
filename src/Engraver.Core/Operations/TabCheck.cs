using Engraver.Core.Geometry;
using Engraver.Core.Sequencing;
using Engraver.Core.Toolpaths;
using Engraver.Core.Verification;

namespace Engraver.Core.Operations;

/// <summary>Compares the tabs of a stroke with those that its operation states: their number, width and height, and that fewer are cut only where there is no
/// room.</summary>
/// <param name="shape">The shape of the operation; its rows are the sides.</param>
internal sealed class TabCheck(ShapedOperation shape)
{
    private const double DepthRounding = 1e-9;
    private const double LengthRounding = 1e-6;

    /// <summary>A row with its middle as near as this to a stroke is a part of it, mm.</summary>
    private const double OnStroke = 1e-4;

    /// <param name="stroke">A pass with its leads.</param>
    /// <param name="contour">The same without its leads and without moves straight up and down.</param>
    /// <param name="level">Height of the pass.</param>
    public bool IsFault(ToolpathStroke stroke, ToolpathStroke contour, double level)
    {
        var raised = stroke.Moves.Where(move => move.Role == StrokeRole.Tab).ToList();
        if (shape.Operation is not { Tabs: { } tabs, Depth: { } depth } || !contour.Start.IsNear(contour.End, LengthRounding)) return raised.Count > 0;
        var (top, span) = (tabs.Height - depth, tabs.Width + shape.Part.Tool.Diameter);
        if (level >= top - DepthRounding) return raised.Count > 0;
        var up = raised.Where(move => move.Segment.Length > 0.0).ToList();
        if (raised.Count != 3 * up.Count || up.Any(move => Math.Abs(move.StartZ - top) > DepthRounding || move.EndZ != move.StartZ || Math.Abs(move.Segment.Length - span) > LengthRounding)) return true;
        var wanted = tabs.CountOn(contour.Length);
        return up.Count > wanted + tabs.At.Count || (up.Count < wanted && HasRoom(contour, up, span));
    }

    /// <summary>True when another tab fits on a side of the stroke: away from the ends of the side, the start of the stroke and the other tabs.</summary>
    private bool HasRoom(ToolpathStroke contour, List<StrokeMove> up, double span)
    {
        for (var row = 0; row < shape.Path.Count; row++)
        {
            var side = shape.Path[row].ToSegment();
            if ((side.Kind != SegmentKind.Line && side.Arc.Radius < 2.0 * span) || side.Length < 1.5 * span || !contour.Moves.Any(move => move.Segment.DistanceTo(side.PointAt(0.5)) < OnStroke)) continue;
            var ends = new List<(double From, double To, double Margin)> { (0.0, 0.0, 0.75 * span), (side.Length, side.Length, 0.75 * span) };
            if (On(side, contour.Start) is { } start) ends.Add((start, start, 0.75 * span));
            foreach (var tab in up)
            {
                if (On(side, tab.Segment.PointAt(0.5)) is { } middle) ends.Add((middle - (0.5 * span), middle + (0.5 * span), span));
            }

            ends.Sort();
            if (ends.Zip(ends.Skip(1)).Any(pair => pair.Second.From - pair.First.To > pair.First.Margin + pair.Second.Margin + LengthRounding)) return true;
        }

        return false;
    }

    /// <summary>Distance along a side of a place on it; null for a place beside it.</summary>
    private static double? On(in Segment side, Point2D place) => PerpendicularFoot.Place(side, place, double.NaN) is { Distance: < OnStroke } foot ? foot.Foot * side.Length : null;
}
