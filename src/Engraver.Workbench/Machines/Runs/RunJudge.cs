using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Motion;
using Engraver.Core.Sequencing;
using Engraver.Core.Verification;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Machines.Runs;

/// <summary>Compares what the motors did with the drawing. It uses what the controller or the simulator's record says, never the planned motion.</summary>
public static class RunJudge
{
    /// <summary>What was found while the controller ran.</summary>
    public static RunJudgement ByRecord(TraceVerdict found) => new(found.CuttingSamples == 0 ? null : found.MaxDeviation, found.MissingLength, "record") { DeviationAt = found.DeviationAt?.Place, MissingAt = found.MissingAt };

    /// <summary>A judge that compares recorded motion with the drawing.</summary>
    /// <param name="bridges">Lines that may be cut besides; what is missing is then not to be asked of the verdict.</param>
    internal static ITraceJudge JudgeOf(PreparedJob job, IReadOnlyList<StrokeMove>? bridges = null) => job.Settings.Machine.Height is { } drive
        ? new HeightJudge([.. StrokeMove.AllOf(job.Analysed), .. bridges ?? []], drive.CutDepth, drive.DepthPerPass, Tolerances(job))
        : PlanJudgeOf(job, bridges, Tolerances(job));

    /// <summary>The same in plan only, whatever drives the tool.</summary>
    internal static ITraceJudge PlanJudgeOf(PreparedJob job, IReadOnlyList<StrokeMove>? bridges, TraceTolerances tolerances) =>
        new TraceJudge([.. job.Analysed.ToSegments(), .. (bridges ?? []).Select(bridge => bridge.Segment)], tolerances);

    /// <summary>Keeps where a machine was, with its distance from the drawing.</summary>
    internal static RunTraceBuilder PlacesOf(PreparedJob job) => new(job.Analysed.ToSegments());

    /// <summary>The places that a controller was polled for.</summary>
    internal static RunTrace PolledPlaces(PreparedJob job, JobResult result)
    {
        var places = PlacesOf(job);
        foreach (var point in result.PolledTrace) places.Add(Sample(job.Settings.Machine, point.Seconds, point.Place, point.ToolOn, point.Error));
        return places.ToTrace("polled");
    }

    /// <summary>A place that a job has told while it runs; of a dry run the path counts as cut.</summary>
    internal static TraceSample Sample(PreparedJob job, JobProgress told, bool isDryRun) => Sample(job.Settings.Machine, told.Seconds, told.Place, told.ToolOn || (isDryRun && told.IsOnPath), told.Error);

    /// <summary>Judges by positions polled during a run on a real link, and by the segments that the controller counted as executed; the one under way counts up to the last position known on it.</summary>
    public static RunJudgement ByPolling(PreparedJob job, MotionProgram program, JobResult result)
    {
        var profile = job.Settings.Machine;
        var trace = result.PolledTrace.Select(point => Sample(profile, point.Seconds, point.Place, point.ToolOn)).ToArray();
        if (!trace.Any(sample => sample.Cutting)) return RunJudgement.Unknown;
        var judge = JudgeOf(job);
        foreach (var sample in trace) judge.Add(sample);
        var found = judge.Verdict();
        var planned = program.Strokes.Sum(stroke => stroke.Sequences.Sum(sequence => sequence.Length));
        var tolerances = Tolerances(job);
        var cut = result.LengthByStroke.Sum() + UnfinishedSegment.CutLength(program, result, tolerances.Deviation / tolerances.Count);
        var missing = Math.Max(0.0, planned - cut) / profile.Scale.Largest;
        return new RunJudgement(found.MaxDeviation, result.IsEndKnown ? missing : null, "polled") { DeviationAt = found.DeviationAt?.Place };
    }

    /// <summary>The differences that a correct run of the job may have.</summary>
    public static TraceTolerances Tolerances(PreparedJob job) => TraceTolerances.Default with
    {
        Count = CoarsestCount(job.Settings.Machine),
        MaxError = job.Settings.MaxErrorMm,
    };

    /// <summary>Millimetres; of the Z axis too, where it cuts.</summary>
    private static double CoarsestCount(MachineProfile profile) => 1.0 / (profile.Height is null ? profile.Scale.Smallest : Math.Min(profile.Scale.Smallest, Math.Abs(profile.Scale.Z)));

    private static TraceSample Sample(MachineProfile profile, double seconds, CountsPoint counts, bool cutting, CountsPoint? error = null)
    {
        var place = profile.Scale.ToMillimetres(counts.X, counts.Y);
        return new(seconds, place.X, place.Y, cutting, profile.Scale.ToMillimetres(counts.Z)) { FollowingMm = error is { } known ? double.Hypot(known.X / profile.Scale.X, known.Y / profile.Scale.Y) : null };
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
