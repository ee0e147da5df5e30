using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Motion;
using Engraver.Core.Sequencing;
using Engraver.Core.Verification;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Machines.Runs;

/// <summary>Holds what the motors did against the drawing. It never looks at our own plan of the motion, only at what the controller or the simulator's record says.</summary>
public static class RunJudge
{
    /// <summary>What was found while the controller ran.</summary>
    public static RunJudgement ByRecord(TraceVerdict found) => new(found.CuttingSamples == 0 ? null : found.MaxDeviation, found.MissingLength, "record") { DeviationAt = found.DeviationAt?.Place, MissingAt = found.MissingAt };

    /// <summary>A judge of the drawing that a record can be told to.</summary>
    /// <param name="bridges">Lines that may be cut besides; what is missing is then not to be asked of the verdict.</param>
    internal static TraceJudge JudgeOf(PreparedJob job, IReadOnlyList<StrokeMove>? bridges = null) =>
        new([.. job.Analysed.ToSegments(), .. (bridges ?? []).Select(bridge => bridge.Segment)], Tolerances(job));

    /// <summary>Judges by positions polled during a run on a real link, and by the segments that the controller counted as executed; the one under way counts up to the last position known on it.</summary>
    public static RunJudgement ByPolling(PreparedJob job, MotionProgram program, JobResult result)
    {
        var profile = job.Settings.Machine;
        var trace = result.PolledTrace.Select(point => Sample(profile, point.Seconds, point.X, point.Y, point.ToolOn)).ToArray();
        if (!trace.Any(sample => sample.Cutting)) return RunJudgement.Unknown;
        var found = TraceComparison.Compare(job.Analysed.ToSegments(), trace, Tolerances(job));
        var planned = program.Strokes.Sum(stroke => stroke.Sequences.Sum(sequence => sequence.Length));
        var tolerances = Tolerances(job);
        var cut = result.LengthByStroke.Sum() + UnfinishedSegment.CutLength(program, result, tolerances.Deviation / tolerances.Count);
        var missing = Math.Max(0.0, planned - cut) / profile.Scale.Largest;
        return new RunJudgement(found.MaxDeviation, result.IsEndKnown ? missing : null, "polled") { DeviationAt = found.DeviationAt?.Place };
    }

    /// <summary>What a faithful run of the job may differ by.</summary>
    public static TraceTolerances Tolerances(PreparedJob job) => TraceTolerances.Default with
    {
        Count = 1.0 / job.Settings.Machine.Scale.Smallest,
        MaxError = job.Settings.MaxErrorMm,
    };

    private static TraceSample Sample(MachineProfile profile, double seconds, long x, long y, bool cutting)
    {
        var place = profile.Scale.ToMillimetres(x, y);
        return new(seconds, place.X, place.Y, cutting);
    }
}

/// <summary>What a run is worth, by what the controller or the simulator's record says; null where nothing is known.</summary>
/// <param name="MaxDeviationMm">Largest distance of a cutting sample from the drawing.</param>
/// <param name="MissingLengthMm">Drawn length that was never cut; null too when the link was lost and the controller went on alone.</param>
/// <param name="Source">"record", "polled" or "none".</param>
public sealed record RunJudgement(double? MaxDeviationMm, double? MissingLengthMm, string Source)
{
    public static RunJudgement Unknown { get; } = new(null, null, "none");

    /// <summary>Where on the drawing the machine was furthest from it, millimetres; null where that is not known.</summary>
    public Point2D? DeviationAt { get; init; }

    /// <summary>The first place of the drawing that was never cut, millimetres; null where nothing is missing or nobody knows where.</summary>
    public Point2D? MissingAt { get; init; }
}
