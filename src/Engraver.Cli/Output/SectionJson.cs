using System.Text.Json.Serialization;
using Engraver.Workbench.Machines.Runs;

namespace Engraver.Cli.Output;

/// <summary>A section of a run; names, units and meanings are the runner's contract.</summary>
/// <param name="Number">In the job, from 1.</param>
/// <param name="Tool">Number of the tool.</param>
/// <param name="Operations">Ids.</param>
/// <param name="Outcome">How it ended.</param>
/// <param name="Journal">Path.</param>
/// <param name="MaxDeviation">Of the strokes of the section, mm; null when unknown.</param>
/// <param name="MissingLength">Of the strokes of the section, mm; null when unknown.</param>
internal sealed record SectionJson(int Number, int Tool, IReadOnlyList<string> Operations, string Outcome, string? Journal, double Seconds, double PlannedSeconds, double? MaxDeviation, double? MissingLength)
{
    /// <summary>Of the strokes of the section where corners were rounded, mm; not written when unknown or without a corner tolerance.</summary>
    [JsonIgnore(Condition = JsonIgnoreCondition.WhenWritingNull)]
    public double? CornerDeviation { get; init; }

    /// <summary>The repeat of the first operation with which it begins after a stop, from 2; not written after a change of the tool.</summary>
    [JsonIgnore(Condition = JsonIgnoreCondition.WhenWritingNull)]
    public int? Repeat { get; init; }

    /// <summary>The sections of a run; null for a job of one section.</summary>
    public static IReadOnlyList<SectionJson>? Of(MachineRunReport report) => report.Sections.Count == 0
        ? null
        : [.. report.Sections.Where(one => one.Section is not null).Select(one => new SectionJson(one.Section!.Number, one.Section.Tool.Tool.Number, [.. one.Section.Tool.Operations.Select(operation => operation.Id)], OutcomeText.Token(one.Result.Outcome), one.Journal, one.Result.Seconds, one.PlannedSeconds, one.Judgement.MaxDeviationMm, one.Judgement.MissingLengthMm) { CornerDeviation = one.Judgement.CornerDeviationMm, Repeat = one.Section.Tool.Repeat })];
}
