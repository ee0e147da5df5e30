using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Sequencing;
using Engraver.Core.Verification;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Machines.Runs;

/// <summary>Compares the motion of the motors with the drawing, using the data of the controller or the simulator's record, not the planned motion.</summary>
public static class RunJudge
{
    /// <summary>The verdict of the run.</summary>
    /// <param name="motors">The judge of the motors; null if only the commanded path is judged.</param>
    internal static RunJudgement ByRecord(TraceVerdict found, MotorJudge? motors = null) =>
        WithMotors(new(found.CuttingSamples == 0 ? null : found.MaxDeviation, found.MissingLength, "record") { CornerDeviationMm = found.CuttingSamples == 0 ? null : found.CornerDeviation, DeviationAt = found.DeviationAt?.Place, MissingAt = found.MissingAt }, motors);

    /// <summary>Compares the motors of a job with the drawing, in XY: the lag of Z is part of the following error.</summary>
    internal static MotorJudge MotorsOf(PreparedJob job) => new(() => PlanJudgeOf(job, null, Tolerances(job)));

    /// <summary>Combines the verdict on the commanded path with that on the motors, if known.</summary>
    internal static RunJudgement WithMotors(RunJudgement path, MotorJudge? motors) => motors?.Following is not { } following || path.MaxDeviationMm is not { } commanded ? path : path with
    {
        MaxDeviationMm = Math.Max(commanded, motors.Deviation),
        CornerDeviationMm = path.CornerDeviationMm is { } rounded ? Math.Max(rounded, motors.CornerDeviation) : null,
        DeviationAt = motors.Deviation > commanded ? motors.DeviationAt : path.DeviationAt,
        CommandedDeviationMm = commanded,
        FollowingMm = following,
        FollowingAt = motors.FollowingAt,
    };

    /// <summary>The following error that the profile allows at the fastest cutting speed of a program, mm: the allowed deviation of servos at corners and
    /// arcs.</summary>
    internal static double AllowedFollowing(MotionProgram program)
    {
        var fastest = program.Strokes.SelectMany(stroke => stroke.Sequences).Select(sequence => sequence.Speed).DefaultIfEmpty().Max();
        return program.Profile.FollowingErrorAt(program.Profile.Scale.Coarser.LengthOf(fastest));
    }

    /// <summary>A judge that compares recorded motion with the drawing.</summary>
    /// <param name="bridges">Additional lines that may be cut; the missing length of the verdict is then meaningless.</param>
    /// <param name="tolerances">Tolerances; null for those of a run.</param>
    internal static ITraceJudge JudgeOf(PreparedJob job, IReadOnlyList<StrokeMove>? bridges = null, TraceTolerances? tolerances = null) => job.Settings.CuttingMachine.Height is { } drive
        ? new HeightJudge([.. StrokeMove.AllOf(job.Analysed), .. bridges ?? []], drive.CutDepth, drive.DepthPerPass, tolerances ?? Tolerances(job))
        : PlanJudgeOf(job, bridges, tolerances ?? Tolerances(job));

    /// <summary>The same in XY only, with or without a tool axis.</summary>
    internal static ITraceJudge PlanJudgeOf(PreparedJob job, IReadOnlyList<StrokeMove>? bridges, TraceTolerances tolerances) =>
        new TraceJudge([.. job.Analysed.ToSegments(), .. (bridges ?? []).Select(bridge => bridge.Segment)], tolerances);

    /// <summary>Creates the builder of a trace with the deviation from the drawing.</summary>
    internal static RunTraceBuilder PlacesOf(PreparedJob job) => new(job.Analysed.ToSegments(), rounding: Tolerances(job));

    /// <summary>The conditions of a running job, for its trace.</summary>
    internal static TraceConditions ConditionsOf(JobProgress told) => new(told.FeedRatio, told.LinkLoad);

    /// <summary>A sample from the progress of a running job; in a dry run the path counts as cut.</summary>
    /// <param name="error">The last reported position error; null if it is not polled.</param>
    internal static TraceSample Sample(PreparedJob job, JobProgress told, bool isDryRun, CountsPoint? error) =>
        MotorSample(job.Settings.CuttingMachine, new TracePoint(told.Seconds, told.Place, told.ToolOn || (isDryRun && told.IsOnPath)) { Error = error });

    /// <summary>The allowed deviations of a correct run.</summary>
    public static TraceTolerances Tolerances(PreparedJob job) => new()
    {
        Count = CoarsestCount(job.Settings.CuttingMachine),
        MaxError = job.Settings.MaxErrorMm,
        CornerTolerance = job.Settings.CuttingMachine.Scale.IsUniform ? job.Settings.CornerToleranceMm : 0.0, // an arc in counts would be an ellipse otherwise
        JoinTolerance = job.Settings.JoinToleranceMm,
    };

    /// <summary>Size of the coarsest count, millimetres; includes Z if the tool axis cuts.</summary>
    private static double CoarsestCount(MachineProfile profile) => profile.Height is null ? profile.Scale.Coarser.LengthOf(1.0) : Math.Max(profile.Scale.Coarser.LengthOf(1.0), profile.Scale.Z.LengthOf(1.0));

    /// <summary>The motor position: the commanded position minus the position error, if it was polled.</summary>
    internal static TraceSample MotorSample(MachineProfile profile, TracePoint point) => CommandedSample(profile, point.Seconds, point.Place - (point.Error ?? default), point.ToolOn, point.Error);

    internal static TraceSample CommandedSample(MachineProfile profile, double seconds, CountsPoint counts, bool cutting, CountsPoint? error = null)
    {
        var place = profile.Scale.ToMillimetres(counts.X, counts.Y);
        return new(seconds, place.X, place.Y, cutting, profile.Scale.ToMillimetres(counts.Z)) { FollowingMm = error is { } known ? Following(profile, known) : null };
    }

    /// <summary>Length of the position error, millimetres; includes Z with a tool axis.</summary>
    private static double Following(MachineProfile profile, CountsPoint error) =>
        double.Hypot(profile.Scale.ToMillimetres(new Vector2D(error.X, error.Y)).Length, profile.Height is null ? 0.0 : profile.Scale.ToMillimetres(error.Z));
}
