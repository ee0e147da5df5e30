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

    /// <summary>Part by which chords of a slope on an arc may be steeper.</summary>
    private const double SlopeTolerance = 0.02;

    /// <summary>A row with its middle as near as this to a stroke is a part of it, mm.</summary>
    private const double OnStroke = 1e-4;

    /// <param name="pieces">The strokes of a pass of a contour.</param>
    /// <param name="contour">What they cut.</param>
    /// <param name="level">Height of the pass.</param>
    /// <param name="falls">Differences of the heights of the passes, the largest of which, at most the height of the tabs, determines where a descent has
    /// none.</param>
    public bool IsFault(IReadOnlyList<ToolpathStroke> pieces, StrokeContour contour, double level, IReadOnlyList<double> falls)
    {
        var raised = pieces.SelectMany(piece => piece.Moves).Where(move => move.Role == StrokeRole.Tab).ToList();
        if (shape.Operation.Tabs is not { } tabs || !contour.IsClosed) return raised.Count > 0 || pieces.Count > 1;
        var span = tabs.Width + shape.Part.Tool.Diameter;
        if (shape.Operation.Depth is not { } depth) return raised.Count > 0 || contour.Gaps.Count != pieces.Count - 1 || contour.Gaps.Any(gap => Math.Abs(gap - span) > LengthRounding) || IsNumberFault(tabs, contour, span, falls);
        var (top, slope) = (tabs.Height!.Value - depth, tabs.Slope);
        if (level >= top - DepthRounding) return raised.Count > 0 || pieces.Count > 1;
        var up = raised.Where(move => move.StartZ == move.EndZ).ToList();
        if (pieces.Count > 1 || up.Any(move => Math.Abs(move.StartZ - top) > DepthRounding || Math.Abs(move.Segment.Length - span) > LengthRounding)) return true;
        var beside = raised.Where(move => move.StartZ != move.EndZ).ToList();
        if (Math.Abs(beside.Sum(move => Math.Abs(move.EndZ - move.StartZ)) - (2.0 * up.Count * (top - level))) > DepthRounding * (1 + raised.Count)) return true;
        if (beside.Any(move => double.IsInfinity(slope) ? move.Segment.Length > 0.0 : Math.Abs((Math.Abs(move.EndZ - move.StartZ) / move.Segment.Length / slope) - 1.0) > SlopeTolerance)) return true;
        return IsNumberFault(tabs, contour, span + (2.0 * tabs.Height.Value / slope), falls);
    }

    private bool IsNumberFault(PartTabs tabs, StrokeContour contour, double span, IReadOnlyList<double> falls)
    {
        var (wanted, middles) = (tabs.CountOn(contour.Stroke.Length), MiddlesOf(contour));
        return middles.Count > wanted + tabs.At.Count || (middles.Count < wanted && HasRoom(contour, middles, span, falls));
    }

    /// <summary>The middle of each tab: of each run of moves at it, slopes included.</summary>
    private static List<Point2D> MiddlesOf(StrokeContour contour)
    {
        var (middles, run) = (new List<Point2D>(), new List<StrokeMove>());
        foreach (var move in contour.Stroke.Moves.Append(default))
        {
            if (move.Role == StrokeRole.Tab) run.Add(move);
            else if (run.Count > 0)
            {
                middles.Add(run[run.Count / 2].Segment.PointAt(0.5));
                run.Clear();
            }
        }

        return middles;
    }

    /// <summary>True when another tab fits on a side of the stroke: away from the ends of the side, the start of the stroke, its overcut and descent, and the
    /// other tabs.</summary>
    private bool HasRoom(StrokeContour contour, List<Point2D> middles, double span, IReadOnlyList<double> falls)
    {
        var moves = contour.Stroke.Moves;
        var descent = shape.Operation.RampDegrees is { } angle ? Math.Min(falls.Max(), shape.Operation.Tabs!.Height ?? double.PositiveInfinity) / Math.Tan(angle * Math.PI / 180.0) : 0.0;
        var reach = shape.Operation.HelixReachOf(shape.Part.Tool);
        var (atStart, atEnd) = (Math.Max(contour.Overcut.Sum(move => move.Segment.Length), reach), contour.Stroke.Length - Math.Max(descent, reach));
        for (var row = 0; row < shape.Path.Count; row++)
        {
            var side = shape.Path[row].ToSegment();
            if ((side.Kind != SegmentKind.Line && side.Arc.Radius < 2.0 * span) || side.Length < 1.5 * span || !moves.Any(move => move.Segment.DistanceTo(side.PointAt(0.5)) < OnStroke)) continue;
            var ends = new List<(double From, double To, double Margin)> { (0.0, 0.0, 0.75 * span), (side.Length, side.Length, 0.75 * span) };
            if (On(side, contour.Stroke.Start) is { } start) ends.Add((start, start, 0.75 * span));
            ends.AddRange(middles.Select(middle => On(side, middle)).OfType<double>().Select(middle => (middle - (0.5 * span), middle + (0.5 * span), span)));
            var along = 0.0;
            foreach (var segment in moves.Select(move => move.Segment))
            {
                // A part of a move near the start or the end has no tabs.
                foreach (var (from, to) in ((double, double)[])[(0.0, Math.Min(1.0, (atStart - along) / segment.Length)), (Math.Max(0.0, (atEnd - along) / segment.Length), 1.0)])
                {
                    if (to > from && On(side, segment.PointAt(from)) is { } one && On(side, segment.PointAt(to)) is { } other && On(side, segment.PointAt((from + to) / 2.0)) is not null) ends.Add((Math.Min(one, other), Math.Max(one, other), 0.75 * span));
                }

                along += segment.Length;
            }

            ends.Sort();
            var reached = ends[0];
            foreach (var end in ends.Skip(1))
            {
                if (end.From - reached.To > reached.Margin + end.Margin + LengthRounding) return true;
                if (end.To >= reached.To) reached = end;
            }
        }

        return false;
    }

    /// <summary>Distance along a side of a place on it; null for a place beside it.</summary>
    private static double? On(in Segment side, Point2D place) => PerpendicularFoot.Place(side, place, double.NaN) is { Distance: < OnStroke } foot ? foot.Foot * side.Length : null;
}
