using Engraver.Core.Diagnostics;
using Engraver.Core.Geometry;

namespace Engraver.Core.Trajectories.Formats;

/// <summary>What is to be said of trajectories, whoever makes them.</summary>
public static class TrajectoryFindings
{
    /// <summary>What the controller does not take, and a feed that asks an axis for more acceleration than it has.</summary>
    /// <param name="name">By which the operator knows the file.</param>
    public static IEnumerable<Diagnostic> LimitsOf(TrajectoryFile file, string name, TrajectoryMotion motion)
    {
        foreach (var limit in file.BrokenLimits) yield return TrajectoryRules.LimitBroken.At(default, name, limit);
        if (file.MaxSpeed is not { } speed || speed >= motion.Velocity) yield break;
        var needed = motion.Acceleration * motion.Velocity * motion.Velocity / (speed * speed);
        yield return TrajectoryRules.TooFast.At(default, name, FactText.Of(motion.Velocity), FactText.Of(Math.Ceiling(needed)), FactText.Of(motion.Acceleration), FactText.Of(Math.Floor(speed * 1000.0) / 1000.0));
    }

    /// <summary>Runs for which no spline was proven to keep the error.</summary>
    public static IEnumerable<Diagnostic> NotKept(IEnumerable<IReadOnlyList<Segment>> unproven, double maxErrorMm) =>
        unproven.Select(run => TrajectoryRules.ErrorNotKept.At(default, FactText.Of(maxErrorMm), FactText.Of(run.Sum(segment => segment.Length)), FactText.Of(run[0].Start.X), FactText.Of(run[0].Start.Y)));
}
