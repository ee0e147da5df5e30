using System.Globalization;
using Engraver.Core.Machines;
using Engraver.Core.Motion;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Reports;

namespace Engraver.Cli.Output;

/// <summary>Reports the plan of a job.</summary>
internal static class PlanReport
{
    /// <param name="program">The job's program with feeds limited to the link; null when this machine can cut nothing.</param>
    /// <param name="sheet">Of the program over the link; null without a program.</param>
    /// <param name="timesOf">Times of a part of the program over the link.</param>
    public static PlanJson Json(PreparedJob job, MotionProgram? program, JobSheet? sheet, Func<MotionProgram, MotionTimes> timesOf)
    {
        var (length, travel) = (job.Sequence.PathLength, job.Sequence.Travel);
        PlanJson.PlanUncutJson[] uncut = [.. (job.Kerf?.Uncut ?? job.Shapes.SelectMany(shape => shape.Uncut)).Select(place => new PlanJson.PlanUncutJson(place.Place.X, place.Place.Y, place.Uncut, place.IsWhole))];
        if (program is null || sheet is null) return new PlanJson(null, length, travel, null, null, null, job.NotCut.Counts, null, uncut, job.Fonts) { Operations = OperationJson.Of(job, []), Sections = SectionsOf(job, program, timesOf) };
        var peaks = MotionPeaks.From(program);
        return new PlanJson(PlanJson.PlanSecondsJson.From(sheet.Times), length, travel, peaks.Speed, peaks.AxisAcceleration, sheet.Cost?.Total, job.NotCut.Counts, PlanJson.PlanCostJson.From(sheet.Cost), uncut, job.Fonts)
        {
            Operations = OperationsOf(job, sheet.Shares),
            Sections = SectionsOf(job, program, timesOf),
            Tools = sheet.Shares is { } shares ? [.. shares.Tools.Select(one => new PlanJson.PlanToolJson(one.Tool.Number, one.Tool.Name, [.. one.Operations.Select(operation => operation.Id)], one.Share.Strokes, one.Share.CutLength, PlanShareJson.From(one.Share)))] : null,
            Around = sheet.Shares is { Around: var around } ? PlanShareJson.From(around) : null,
        };
    }

    public static void Text(TextWriter output, PlanJson plan)
    {
        output.WriteLine(Wording.Get("PlanReport.Lengths", plan.CutLength, plan.Travel));
        foreach (var one in plan.Operations ?? []) output.WriteLine(Wording.Get("PlanReport.Operation", one.Name.Length > 0 ? one.Name : one.Id, one.Kind, one.Tool, one.Curves, one.Strokes, one.Length, one.Feed));
        foreach (var one in plan.Sections ?? []) output.WriteLine(Wording.Get(one.Repeat is null ? "PlanReport.Section" : "PlanReport.RepeatSection", one.Number, one.Title, string.Join(", ", one.Operations), one.Strokes, one.Seconds ?? 0.0, one.Repeat ?? 1));
        if (plan.Seconds is not { } seconds) return;
        output.WriteLine(Wording.Get("PlanReport.Times", seconds.Total, seconds.Cutting, seconds.Rapid, seconds.Dwell));
        output.WriteLine(Wording.Get("PlanReport.Peaks", plan.PeakSpeed, plan.PeakAxisAcceleration));
        if (plan is { Cost: { } cost, CostParts: { } parts }) output.WriteLine(Wording.Get("PlanReport.Cost", cost, parts.Time, parts.Length, parts.Starts));
    }

    /// <summary>Null for a job without operations.</summary>
    private static IReadOnlyList<OperationJson>? OperationsOf(PreparedJob job, JobShares? shares) =>
        shares is null ? null : [.. OperationJson.Of(job, [])!.Zip(shares.Operations, (json, one) => json with { Planned = PlanShareJson.From(one.Share) })];

    /// <summary>Null for a job of one section.</summary>
    private static IReadOnlyList<PlanJson.PlanSectionJson>? SectionsOf(PreparedJob job, MotionProgram? program, Func<MotionProgram, MotionTimes> timesOf)
    {
        if (job.Sections is not { Count: > 1 } tools) return null;
        var parts = program is null ? [] : JobSection.Of(job, program);
        return [.. tools.Select((tool, index) => new PlanJson.PlanSectionJson(index + 1, tool.Tool.Number, [.. tool.Operations.Select(operation => operation.Id)], tool.Strokes, program is null ? null : timesOf(parts[index].Of(program)).Total) { Title = tool.Tool.Title, Repeat = tool.Repeat })];
    }

    private static string Invariant(FormattableString text) => text.ToString(CultureInfo.InvariantCulture);
}
