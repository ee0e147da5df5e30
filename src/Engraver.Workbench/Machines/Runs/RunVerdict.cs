using Engraver.Core;
using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Verification;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Machines.Runs;

/// <summary>Changes the outcome of a run whose measured deviation or missing length exceeds the tolerance to <see cref="JobOutcome.Deviated"/>, regardless of
/// the controller's counters.</summary>
internal static class RunVerdict
{
    /// <summary>Nominal sample of the controller's motion, seconds: two axes queried in sequence may differ by this time (galil-dmc.md C).</summary>
    private const double SampleSeconds = 0.001;

    /// <returns>The unchanged result, or <see cref="JobOutcome.Deviated"/> with position and size.</returns>
    public static JobResult Judge(PreparedJob job, MotionProgram program, JobResult result, RunJudgement judgement)
    {
        if (!result.Outcome.IsAsPlanned()) return result;
        var tolerances = RunJudge.Tolerances(job);
        var (allowed, lag) = (AllowedDeviation(job, program, judgement, tolerances), RunJudge.AllowedFollowing(program));
        if ((judgement.CommandedDeviationMm ?? judgement.MaxDeviationMm) is { } commanded && commanded > allowed)
            return Deviated(result, Wording.Get("RunVerdict.RunDeviated", NumberText.Rounded(commanded, 4), NumberText.Rounded(allowed, 4)), judgement.DeviationAt);
        if (judgement.CommandedDeviationMm is not null && judgement.MaxDeviationMm is { } deviation && deviation > allowed + lag)
            return Deviated(result, Wording.Get("RunVerdict.MotorsDeviated", NumberText.Rounded(deviation, 4), NumberText.Rounded(allowed + lag, 4)), judgement.DeviationAt);
        if (judgement.FollowingMm is { } following && following > lag)
            return Deviated(result, Wording.Get("RunVerdict.FollowingErrorTooLarge", NumberText.Rounded(following, 4), NumberText.Rounded(lag, 4)), judgement.FollowingAt);
        if (judgement.MissingLengthMm is { } missing && missing > AllowedMissing(judgement, tolerances))
            return Deviated(result, Wording.Get("RunVerdict.NotCut", NumberText.Rounded(missing, 4)), judgement.MissingAt);
        if (judgement.Operations.FirstOrDefault(operation => operation.OutputFaults is not null) is { } wrong)
            return Deviated(result, Wording.Get("RunVerdict.WrongOutputs", wrong.Title, wrong.OutputFaults), null);
        return result;
    }

    /// <summary>Maximum allowed deviation of a run, mm, including the allowed following error of servos if it is known.</summary>
    public static double Tolerance(PreparedJob job, MotionProgram program, RunJudgement judgement) =>
        AllowedDeviation(job, program, judgement, RunJudge.Tolerances(job)) + (judgement.FollowingMm is null ? 0.0 : RunJudge.AllowedFollowing(program));

    /// <param name="what">A sentence.</param>
    /// <param name="place">Drawing point of the largest value, mm; null if unknown.</param>
    private static JobResult Deviated(JobResult result, string what, Point2D? place) => result with
    {
        Outcome = JobOutcome.Deviated,
        Message = string.Join(' ', (string[])[what, .. At(place), Wording.Get("RunVerdict.CheckWorkpiece")]),
    };

    /// <summary>If the join tolerance bridges gaps, the middle of a bridge is correct although it is off the drawing.</summary>
    private static double AllowedDeviation(PreparedJob job, MotionProgram program, RunJudgement judgement, TraceTolerances tolerances)
    {
        var bridges = BridgedGaps.LargerThan(job.Toolpath, tolerances.Deviation);
        var bridged = tolerances.Deviation + (bridges.Count == 0 ? 0.0 : bridges.Max(bridge => bridge.Segment.Length) / 2.0);
        return judgement.Source == "polled" ? bridged + Skew(program, tolerances) : bridged;
    }

    /// <summary>Allowed distance of a polled position from the path, because its two coordinates are one sample apart: half the distance of a sample in a
    /// diagonal direction. Smaller deviations are monitored by the job (PathWatch).</summary>
    private static double Skew(MotionProgram program, TraceTolerances tolerances) =>
        program.Strokes.SelectMany(stroke => stroke.Sequences).Select(sequence => sequence.Speed).DefaultIfEmpty().Max() * SampleSeconds / 2.0 * tolerances.Count;

    /// <summary>A record is judged by its samples. With polling the length is a sum of segments, and a recomputed arc may be slightly shorter or
    /// longer.</summary>
    private static double AllowedMissing(RunJudgement judgement, TraceTolerances tolerances) => judgement.Source == "record" ? tolerances.Deviation : tolerances.LargestStep;

    private static string[] At(Point2D? place) => place is { } at ? [Wording.Get("RunVerdict.Position", at.X, at.Y)] : [];
}
