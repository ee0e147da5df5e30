using Engraver.Core.Geometry;
using Engraver.Core.Sequencing;
using Engraver.Core.Toolpaths;

namespace Engraver.Core.Operations;

/// <summary>Compares the moves before the contour of a stroke with what its operation states: the tool is at the depth before on the lead, and descends along
/// the contour, no steeper than stated and without a gap, to the depth of the pass.</summary>
/// <param name="operation">The operation of the strokes.</param>
/// <param name="tolerance">Largest distance of a chord from the contour, mm.</param>
internal sealed class DescentCheck(Operation operation, double tolerance)
{
    private const double DepthRounding = 1e-9;
    private const double LengthRounding = 1e-6;

    /// <summary>A stroke that would be followed more often may be entered straight down.</summary>
    private const double MostTurns = 99.0;

    /// <param name="stroke">The first stroke of a pass of a contour.</param>
    /// <param name="contour">What it cuts.</param>
    /// <param name="before">Height of the pass before.</param>
    /// <param name="level">Height of the pass.</param>
    public bool IsFault(ToolpathStroke stroke, IReadOnlyList<StrokeMove> contour, double before, double level)
    {
        var entry = stroke.Moves.TakeWhile(move => move.Role is StrokeRole.Lead or StrokeRole.Ramp).ToList();
        var ramp = entry.Where(move => move.Role == StrokeRole.Ramp).ToList();
        if (stroke.Moves.Skip(entry.Count).Any(move => move.Role == StrokeRole.Ramp) || ramp.Count < entry.Count - 1 || (ramp.Count > 0 && entry.FindLastIndex(move => move.Role == StrokeRole.Lead) > 0)) return true;
        if (entry.Where(move => move.Role == StrokeRole.Lead).Any(lead => !Is(lead.StartZ, ramp.Count > 0 ? before : level) || !Is(lead.EndZ, lead.StartZ))) return true;
        if (operation.RampDegrees is not { } angle || before - level <= DepthRounding) return ramp.Count > 0;
        var slope = Math.Tan(angle * Math.PI / 180.0);
        if (ramp.Count == 0) return contour.Sum(move => move.Segment.Length) * MostTurns > (before - level) / slope;
        if (!Is(ramp[0].StartZ, before) || !Is(ramp[^1].EndZ, level) || !ramp[^1].Segment.End.IsNear(contour[0].Segment.Start, LengthRounding)) return true;
        if (ramp.Zip(ramp.Skip(1)).Any(pair => !Is(pair.First.EndZ, pair.Second.StartZ) || !pair.First.Segment.End.IsNear(pair.Second.Segment.Start, LengthRounding))) return true;
        if (ramp.Any(move => move.EndZ > move.StartZ || move.StartZ - move.EndZ > (slope * move.Segment.Length * 1.000001) + DepthRounding)) return true;
        return ramp.Any(move => IsBeside(move.Segment.Start, contour) || IsBeside(move.Segment.PointAt(0.5), contour) || IsBeside(move.Segment.End, contour));
    }

    private static bool Is(double height, double wanted) => Math.Abs(height - wanted) <= DepthRounding;

    private bool IsBeside(Point2D place, IReadOnlyList<StrokeMove> contour) => !contour.Any(move => move.Segment.DistanceTo(place) <= tolerance + LengthRounding);
}
