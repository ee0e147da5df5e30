using Engraver.Core.Geometry;

namespace Engraver.Core.Trajectories.Formats;

/// <summary>A contour as files of one format.</summary>
public static class TrajectoryFiles
{
    /// <summary>One file for each run between two corners, or one for the contour when its corners are rounded within the error (splines only).</summary>
    /// <param name="contour">See <see cref="TrajectoryPlanner.Plan"/>.</param>
    /// <param name="motion">Limits for the formats that contain speeds.</param>
    public static TrajectoryFilesResult Write(IReadOnlyList<Segment> contour, bool closed, TrajectoryOptions options, TrajectoryFormat format, TrajectoryMotion motion)
    {
        ArgumentNullException.ThrowIfNull(options);
        ArgumentNullException.ThrowIfNull(motion);
        if (format is TrajectoryFormat.Sace or TrajectoryFormat.XpsSpline)
        {
            var planned = TrajectoryPlanner.Plan(contour, closed, options);
            return new TrajectoryFilesResult([.. planned.Trajectories.Select(one => format == TrajectoryFormat.Sace ? SplineText.Sace(one) : SplineText.Xps(one, motion))], planned.Unproven);
        }

        var (files, failed) = (new List<TrajectoryFile>(), new List<IReadOnlyList<Segment>>());
        foreach (var (segments, isRound) in ContourRuns.Split(contour, closed, CornerMode.Stop, options.MaxError))
        {
            var file = format == TrajectoryFormat.XpsLineArc ? LineArcText.From(segments, isRound, options, motion) : PvtText.From(SmoothChain.From(segments, isRound), segments, options, motion);
            if (file is not null) files.Add(file);
            else failed.Add(segments);
        }

        return new TrajectoryFilesResult(files, failed);
    }
}

/// <summary>The result for a contour.</summary>
/// <param name="Files">Files in the order of travel.</param>
/// <param name="Unproven">Number of runs for which the error could not be proven.</param>
public sealed record TrajectoryFilesResult(IReadOnlyList<TrajectoryFile> Files, IReadOnlyList<IReadOnlyList<Segment>> Unproven);
