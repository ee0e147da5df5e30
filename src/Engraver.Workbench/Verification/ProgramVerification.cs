using Engraver.Core;
using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.Machines;
using Engraver.Core.Posts;
using Engraver.Core.Sequencing;
using Engraver.Core.Verification;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Machines.Runs;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Verification;

/// <summary>Reads a posted program back and compares its cut with a drawing in both directions.</summary>
public static class ProgramVerification
{
    /// <summary>Time limit of a program as a multiple of the slowest execution mode, plus <see cref="ExtraTimeoutSeconds"/>.</summary>
    private const double TimeoutFactor = 4.0;
    private const double ExtraTimeoutSeconds = 60.0;

    /// <summary>Runs the program and compares.</summary>
    /// <param name="reader">Reader of the program's language.</param>
    /// <param name="settings">The settings of the post: layers, units, start and machine affect the comparison.</param>
    /// <param name="posted">Its post parameters; null for the defaults.</param>
    /// <exception cref="SettingException">A named layer is not in the drawing, or the job has no such section.</exception>
    /// <exception cref="OperationCanceledException">The caller cancelled.</exception>
    public static async Task<VerificationReport> VerifyAsync(ReadBackFile program, IProgramReader reader, Drawing drawing, DrawingSettings settings, IProgress<ReplayProgress>? progress, CancellationToken cancellation, PostParameters? posted = null)
    {
        posted ??= PostParameters.Defaults;
        var job = posted.JobOf(drawing, settings, MotionStyle.Calls, cancellation);
        var (machine, tolerances) = (job.Settings.CuttingMachine, TolerancesOf(job, reader));
        var bridges = BridgedGaps.LargerThan(job.Toolpath, tolerances.Deviation);
        var judges = new ReadBackJudges(job, posted, reader, tolerances, bridges);
        if (posted.Origin is null && !machine.Scale.Counts(job.Settings.Start)) return Report(job, tolerances, [.. job.Motion.Diagnostics.Where(finding => finding.Severity == Severity.Error)], judges.Verdicts(), bridges); // MOT0003: a program cannot start there.
        var expected = TimeSpan.FromSeconds(job.Motion.Program is { } motion ? JobPlan.NetworkTimes(motion).Total : 0.0);
        var request = judges.Request(posted.Origin?.StartCounts(machine.Scale) ?? machine.Scale.ToCounts(job.Settings.Start), expected, TimeSpan.FromSeconds(ExtraTimeoutSeconds) + (TimeoutFactor * (expected + (posted.Origin?.RapidTime(machine) ?? TimeSpan.Zero))));
        var faults = await program.ReadAsync(text => reader.ReplayAsync(text, request, progress, cancellation)).ConfigureAwait(false);
        var report = Report(job, tolerances, faults.Count > 0 ? faults : judges.Findings(), judges.Verdicts(), bridges);
        if (job.LetterFaults is { Count: > 0 } misplaced) report = report with { Ok = false, Diagnostics = [.. misplaced, .. report.Diagnostics] };
        if (report.Ok && judges.ResidualFinding(request.Start, cancellation) is { } behind) report = report with { Ok = false, Diagnostics = [behind] };
        var operations = judges.Operations();
        if (report.Ok && FaultsOf(operations) is { Count: > 0 } faulty) report = report with { Ok = false, Diagnostics = faulty };
        return Blended(report, judges.Blends, posted.AllowedBlendMm) with { SlowestMmPerMinute = judges.Feeds.Slowest, FastestMmPerMinute = judges.Feeds.Fastest, LowestZMm = judges.Feeds.Lowest, Operations = operations };
    }

    /// <summary>Passes and repeats that the program leaves out, without which the whole drawing can be cut, and outputs that it does not switch.</summary>
    private static List<Diagnostic> FaultsOf(IReadOnlyList<MeasuredOperation> operations) =>
    [
        .. operations.Where(operation => operation.Depths.Contains(null)).Select(operation => OperationRules.PassNotCut.At(default, operation.Title, FactText.Of(operation.Depths.Count(depth => depth is null)))),
        .. operations.Where(operation => operation.OutputFaults is not null).Select(operation => OperationRules.OtherOutputs.At(default, operation.Title, FactText.Of(operation.OutputFaults!.Value))),
    ];

    /// <summary>The controller may deviate from the program by its path control: both distances are added. Without a bound they are unknown.</summary>
    private static VerificationReport Blended(VerificationReport report, BlendJudge blends, double allowed)
    {
        if (blends.Largest == 0.0) return report with { ToleranceMm = report.ToleranceMm + allowed };
        var isBounded = double.IsFinite(blends.Largest);
        report = report with { MaxDeviationMm = isBounded ? report.MaxDeviationMm + blends.Largest : null, ToleranceMm = report.ToleranceMm + allowed, BlendMm = isBounded ? blends.Largest : null };
        var finding = !isBounded ? VerificationRules.BlendsWithoutBound.At(new SourceRef(blends.Line), FactText.Of(blends.Line))
            : report.MaxDeviationMm is { } deviation && deviation > report.ToleranceMm ? VerificationRules.BlendsTooFar.At(new SourceRef(blends.Line), FactText.Of(blends.Largest), FactText.Of(blends.Line), NumberText.Rounded(deviation, 4), NumberText.Rounded(report.ToleranceMm, 4))
            : null;
        return finding is null ? report : report with { Ok = false, Diagnostics = [.. report.Diagnostics, finding] };
    }

    /// <summary>A format with a coarser resolution than the machine is allowed its rounding error; corners are rounded in some formats only.</summary>
    private static TraceTolerances TolerancesOf(PreparedJob job, IProgramReader reader)
    {
        var usual = RunJudge.Tolerances(job);
        if (!reader.RoundsCorners) usual = usual with { CornerTolerance = 0.0 };
        return reader.Rounding <= usual.Deviation - usual.MaxError ? usual : usual with { Count = usual.Count * reader.Rounding / (usual.Deviation - usual.MaxError) };
    }

    /// <summary>The largest deviation is always the one from the drawing. If the join tolerance bridges gaps, the drawing with its bridges may be
    /// cut.</summary>
    /// <param name="verdicts">Verdict for the drawing, and for the drawing with bridges if there are any.</param>
    private static VerificationReport Report(PreparedJob job, TraceTolerances tolerances, IReadOnlyList<Diagnostic> faults, TraceVerdict[] verdicts, IReadOnlyList<StrokeMove> bridges)
    {
        var tolerance = tolerances.Deviation;
        var found = verdicts[0];
        var isBridged = bridges.Count > 0 && found.MaxDeviation > tolerance;
        var judged = isBridged ? verdicts[^1] : found;
        var findings = faults.Count > 0 ? faults : [.. Differences(judged with { MissingLength = found.MissingLength, MissingAt = found.MissingAt }, tolerance)];
        var deviation = found.CuttingSamples == 0 || !double.IsFinite(found.MaxDeviation) ? (double?)null : found.MaxDeviation;
        var allowed = tolerance + (!isBridged ? 0.0 : bridges.Max(bridge => bridge.Segment.Length) / 2.0);
        var ok = findings.Count == 0 && judged.ExtraLength == 0.0 && !job.Drawing.HasErrors;
        return new VerificationReport(deviation, allowed, found.MissingLength, judged.ExtraLength, ok, findings) { CornerDeviationMm = found.CuttingSamples == 0 ? null : found.CornerDeviation };
    }

    /// <remarks>A missing length below the allowed deviation is not an error: a stroke shorter than a count (MOT0004) cannot be cut.</remarks>
    private static IEnumerable<Diagnostic> Differences(TraceVerdict found, double tolerance)
    {
        if (found.MaxDeviation > tolerance && found.DeviationAt is { } worst)
            yield return VerificationRules.CutBesideDrawing.At(default, NumberText.Rounded(found.MaxDeviation, 4), NumberText.Rounded(worst.XMm, 4), NumberText.Rounded(worst.YMm, 4), NumberText.Rounded(tolerance, 4));
        if (found.MissingLength > tolerance && found.MissingAt is { } missing) yield return VerificationRules.NotCut.At(default, NumberText.Rounded(found.MissingLength, 4), NumberText.Rounded(missing.X, 4), NumberText.Rounded(missing.Y, 4));
    }
}
