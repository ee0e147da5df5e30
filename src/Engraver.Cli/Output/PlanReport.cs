using System.Globalization;
using Engraver.Core.Machines;
using Engraver.Core.Motion;
using Engraver.Workbench.Documents;

namespace Engraver.Cli.Output;

/// <summary>How the plan of a job is told.</summary>
internal static class PlanReport
{
    /// <param name="program">Of the job, made fit for the link; null when there is nothing this machine can cut.</param>
    /// <param name="times">Of the program, over the link.</param>
    public static PlanJson Json(PreparedJob job, MotionProgram? program, MotionTimes times)
    {
        var (length, travel) = (job.Sequence.PathLength, job.Sequence.Travel);
        if (program is null) return new PlanJson(null, length, travel, null, null, null);
        var peaks = MotionPeaks.From(program);
        return new PlanJson(new PlanJson.PlanSecondsJson(times.Total, times.Cutting, times.Rapid, times.Dwell), length, travel, peaks.Speed, peaks.AxisAcceleration, null);
    }

    public static void Text(TextWriter output, PlanJson plan)
    {
        output.WriteLine(Invariant($"{plan.CutLength:0.###} mm to cut, {plan.Travel:0.###} mm of travel"));
        if (plan.Seconds is not { } seconds) return;
        output.WriteLine(Invariant($"{seconds.Total:0.0} s: {seconds.Cutting:0.0} s cutting, {seconds.Rapid:0.0} s rapid, {seconds.Dwell:0.0} s standing"));
        output.WriteLine(Invariant($"at most {plan.PeakSpeed:0.###} mm/s along the path and {plan.PeakAxisAcceleration:0.#} mm/s2 of one axis"));
    }

    private static string Invariant(FormattableString text) => text.ToString(CultureInfo.InvariantCulture);
}
