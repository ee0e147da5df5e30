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

    private readonly double _slope = Math.Tan((operation.RampDegrees ?? 0.0) * Math.PI / 180.0);

    /// <param name="stroke">The first stroke of a pass of a contour.</param>
    /// <param name="contour">What it cuts.</param>
    /// <param name="before">Height of the pass before.</param>
    /// <param name="level">Height of the pass.</param>
    public bool IsFault(ToolpathStroke stroke, IReadOnlyList<StrokeMove> contour, double before, double level)
    {
        if (operation.HelixRadius is { } radius && stroke.Moves[0].Role == StrokeRole.Ramp && IsHelix(stroke, radius, before, level)) return false;
        var entry = stroke.Moves.TakeWhile(move => move.Role is StrokeRole.Lead or StrokeRole.Ramp).ToList();
        var ramp = entry.Where(move => move.Role == StrokeRole.Ramp).ToList();
        if (stroke.Moves.Skip(entry.Count).Any(move => move.Role == StrokeRole.Ramp) || ramp.Count < entry.Count - 1 || (ramp.Count > 0 && entry.FindLastIndex(move => move.Role == StrokeRole.Lead) > 0)) return true;
        if (entry.Where(move => move.Role == StrokeRole.Lead).Any(lead => !Is(lead.StartZ, ramp.Count > 0 ? before : level) || !Is(lead.EndZ, lead.StartZ))) return true;
        if (operation.RampDegrees is null || before - level <= DepthRounding) return ramp.Count > 0;
        if (ramp.Count == 0) return contour.Sum(move => move.Segment.Length) * MostTurns > (before - level) / _slope;
        return IsSteep(ramp, before, level, contour[0].Segment.Start) || ramp.Any(move => IsBeside(move.Segment.Start, contour) || IsBeside(move.Segment.PointAt(0.5), contour) || IsBeside(move.Segment.End, contour));
    }

    /// <summary>True when the stroke begins with whole turns on a circle of at most the stated radius, from the depth before, whose end is the start of the
    /// next move, at the depth of the pass like everything behind it.</summary>
    private bool IsHelix(ToolpathStroke stroke, double radius, double before, double level)
    {
        var helix = stroke.Moves.TakeWhile(move => move.Role == StrokeRole.Ramp).ToList();
        if (helix.Count == stroke.Moves.Count || stroke.Moves.Skip(helix.Count).Any(move => move.Role == StrokeRole.Ramp) || stroke.Moves.Skip(helix.Count).TakeWhile(move => move.Role == StrokeRole.Lead).Any(lead => !Is(lead.StartZ, level) || !Is(lead.EndZ, level))) return false;
        if (IsSteep(helix, before, level, stroke.Moves[helix.Count].Segment.Start) || !helix[0].Segment.Start.IsNear(helix[^1].Segment.End, LengthRounding)) return false;
        var bounds = new Bounds2D(helix.Min(move => move.Segment.Start.X), helix.Min(move => move.Segment.Start.Y), helix.Max(move => move.Segment.Start.X), helix.Max(move => move.Segment.Start.Y));
        var (centre, half) = (new Point2D((bounds.MinX + bounds.MaxX) / 2.0, (bounds.MinY + bounds.MaxY) / 2.0), Math.Max(bounds.Width, bounds.Height) / 2.0);
        return half <= radius + tolerance + LengthRounding && helix.TrueForAll(move => Math.Abs(move.Segment.Start.DistanceTo(centre) - half) <= (2.0 * tolerance) + LengthRounding);
    }

    /// <summary>True when moves do not descend without a gap from one height to the other, or somewhere too steeply.</summary>
    private bool IsSteep(List<StrokeMove> ramp, double before, double level, Point2D end) =>
        !Is(ramp[0].StartZ, before) || !Is(ramp[^1].EndZ, level) || !ramp[^1].Segment.End.IsNear(end, LengthRounding)
        || ramp.Zip(ramp.Skip(1)).Any(pair => !Is(pair.First.EndZ, pair.Second.StartZ) || !pair.First.Segment.End.IsNear(pair.Second.Segment.Start, LengthRounding))
        || ramp.Exists(move => move.EndZ > move.StartZ || move.StartZ - move.EndZ > (_slope * move.Segment.Length * 1.000001) + DepthRounding);

    private static bool Is(double height, double wanted) => Math.Abs(height - wanted) <= DepthRounding;

    private bool IsBeside(Point2D place, IReadOnlyList<StrokeMove> contour) => !contour.Any(move => move.Segment.DistanceTo(place) <= tolerance + LengthRounding);
}
