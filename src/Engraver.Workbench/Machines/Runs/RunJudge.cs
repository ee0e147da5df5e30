using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Motion;
using Engraver.Core.Sequencing;
using Engraver.Core.Verification;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Machines.Runs;

/// <summary>Compares what the motors did with the drawing. It uses what the controller or the simulator's record says, never the planned motion.</summary>
public static class RunJudge
{
    /// <summary>What was found while the controller ran.</summary>
    /// <param name="motors">What was found of the motors; null where only the commanded path is judged.</param>
    internal static RunJudgement ByRecord(TraceVerdict found, MotorJudge? motors = null) =>
        WithMotors(new(found.CuttingSamples == 0 ? null : found.MaxDeviation, found.MissingLength, "record") { DeviationAt = found.DeviationAt?.Place, MissingAt = found.MissingAt }, motors);

    /// <summary>Compares the motors of a job with the drawing, in plan: how far the height is behind is part of the following error.</summary>
    internal static MotorJudge MotorsOf(PreparedJob job) => new(() => PlanJudgeOf(job, null, Tolerances(job)));

    /// <summary>A verdict on the commanded path and, where they are known, on the motors.</summary>
    internal static RunJudgement WithMotors(RunJudgement path, MotorJudge? motors) => motors?.Following is not { } following || path.MaxDeviationMm is not { } commanded ? path : path with
    {
        MaxDeviationMm = Math.Max(commanded, motors.Deviation),
        DeviationAt = motors.Deviation > commanded ? motors.DeviationAt : path.DeviationAt,
        CommandedDeviationMm = commanded,
        FollowingMm = following,
        FollowingAt = motors.FollowingAt,
    };

    /// <summary>The following error that the profile allows at the fastest cutting speed of a program, mm: by so much healthy servos may be beside a path
    /// that bends.</summary>
    internal static double AllowedFollowing(MotionProgram program)
    {
        var fastest = program.Strokes.SelectMany(stroke => stroke.Sequences).Select(sequence => sequence.Speed).DefaultIfEmpty().Max();
        return program.Profile.FollowingErrorAt(program.Profile.Scale.Coarser.LengthOf(fastest));
    }

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

    /// <summary>A place that a job has told while it runs; of a dry run the path counts as cut.</summary>
    /// <param name="error">The position error that was told last; null where nobody asks.</param>
    internal static TraceSample Sample(PreparedJob job, JobProgress told, bool isDryRun, CountsPoint? error) =>
        MotorSample(job.Settings.Machine, new TracePoint(told.Seconds, told.Place, told.ToolOn || (isDryRun && told.IsOnPath)) { Error = error });

    /// <summary>The differences that a correct run of the job may have.</summary>
    public static TraceTolerances Tolerances(PreparedJob job) => TraceTolerances.Default with
    {
        Count = CoarsestCount(job.Settings.Machine),
        MaxError = job.Settings.MaxErrorMm,
    };

    /// <summary>Millimetres; of the Z axis too, where it cuts.</summary>
    private static double CoarsestCount(MachineProfile profile) => profile.Height is null ? profile.Scale.Coarser.LengthOf(1.0) : Math.Max(profile.Scale.Coarser.LengthOf(1.0), profile.Scale.Z.LengthOf(1.0));

    /// <summary>Where the motors were: the commanded position less the position error, where somebody asked for it.</summary>
    internal static TraceSample MotorSample(MachineProfile profile, TracePoint point) => CommandedSample(profile, point.Seconds, point.Place - (point.Error ?? default), point.ToolOn, point.Error);

    internal static TraceSample CommandedSample(MachineProfile profile, double seconds, CountsPoint counts, bool cutting, CountsPoint? error = null)
    {
        var place = profile.Scale.ToMillimetres(counts.X, counts.Y);
        return new(seconds, place.X, place.Y, cutting, profile.Scale.ToMillimetres(counts.Z)) { FollowingMm = error is { } known ? Following(profile, known) : null };
    }

    /// <summary>Millimetres; of the height too, where an axis holds the tool.</summary>
    private static double Following(MachineProfile profile, CountsPoint error) =>
        double.Hypot(profile.Scale.ToMillimetres(new Vector2D(error.X, error.Y)).Length, profile.Height is null ? 0.0 : profile.Scale.ToMillimetres(error.Z));
}

/// <summary>What a run is worth, by what the controller or the simulator's record says; null where nothing is known.</summary>
/// <param name="MaxDeviationMm">Largest distance of a cutting sample from the drawing: of the motors, where their position error is known, otherwise of
/// what was commanded.</param>
/// <param name="MissingLengthMm">Drawn length that was never cut; null too when the link was lost and the controller went on alone.</param>
/// <param name="Source">"record", "polled" or "none".</param>
public sealed record RunJudgement(double? MaxDeviationMm, double? MissingLengthMm, string Source)
{
    public static RunJudgement Unknown { get; } = new(null, null, "none");

    /// <summary>Largest distance of the commanded path from the drawing, where the motors' own is known; null where only one of the two is, and then it is
    /// <see cref="MaxDeviationMm"/>.</summary>
    public double? CommandedDeviationMm { get; init; }

    /// <summary>Largest following error of the servo axes while the tool cut, mm; null where nobody asked, or steppers move them.</summary>
    public double? FollowingMm { get; init; }

    /// <summary>Where on the commanded path that was, millimetres.</summary>
    public Point2D? FollowingAt { get; init; }

    /// <summary>Where on the drawing the machine was furthest from it, millimetres; null where that is not known.</summary>
    public Point2D? DeviationAt { get; init; }

    /// <summary>The first place of the drawing that was never cut, millimetres; null where nothing is missing or nobody knows where.</summary>
    public Point2D? MissingAt { get; init; }
}
