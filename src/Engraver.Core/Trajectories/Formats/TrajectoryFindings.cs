using Engraver.Core.Diagnostics;
using Engraver.Core.Geometry;

namespace Engraver.Core.Trajectories.Formats;

/// <summary>Findings of trajectories, common to all commands that create them.</summary>
public static class TrajectoryFindings
{
    /// <summary>Properties that the controller does not accept, and a feed for which an axis exceeds its acceleration.</summary>
    /// <param name="name">Name of the file for the operator.</param>
    public static IEnumerable<Diagnostic> LimitsOf(TrajectoryFile file, string name, TrajectoryMotion motion)
    {
        foreach (var limit in file.BrokenLimits) yield return TrajectoryRules.LimitBroken.At(default, name, limit);
        if (file.MaxSpeed is not { } speed || speed >= motion.Velocity) yield break;
        var needed = motion.Acceleration * motion.Velocity * motion.Velocity / (speed * speed);
        yield return TrajectoryRules.TooFast.At(default, name, FactText.Of(motion.Velocity), FactText.Of(Math.Ceiling(needed)), FactText.Of(motion.Acceleration), FactText.Of(Math.Floor(speed * 1000.0) / 1000.0));
    }

    /// <summary>Runs for which no spline was proven to be within the error.</summary>
    public static IEnumerable<Diagnostic> NotKept(IEnumerable<IReadOnlyList<Segment>> unproven, double maxErrorMm) =>
        unproven.Select(run => TrajectoryRules.ErrorNotKept.At(default, FactText.Of(maxErrorMm), FactText.Of(run.Sum(segment => segment.Length)), FactText.Of(run[0].Start.X), FactText.Of(run[0].Start.Y)));
}
