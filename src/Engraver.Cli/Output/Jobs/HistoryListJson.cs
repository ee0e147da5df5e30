using Engraver.Workbench.Histories;
using Engraver.Workbench.LetteredDrawings;

namespace Engraver.Cli.Output.Jobs;

/// <summary>What <c>engraver history --json</c> prints; names, units and meanings are the runner's contract.</summary>
/// <param name="Entries">The newest first.</param>
/// <param name="Findings">A sentence for each invalid file of the index.</param>
internal sealed record HistoryListJson(IReadOnlyList<HistoryListJson.JobJson> Entries, IReadOnlyList<string> Findings)
{
    public static HistoryListJson From(IEnumerable<HistoryEntry> entries, IReadOnlyList<string> findings) => new([.. entries.Select(JobJson.From)], findings);

    /// <summary>The fields have the same meaning as those of <see cref="HistoryEntry"/>.</summary>
    internal sealed record JobJson(
        string Id, DateTimeOffset Date, string Kind, string Drawing, string? DrawingSha256, string Target, string? Mode, string? Address, string Outcome, string Sentence,
        double? Seconds, double? PlannedSeconds, double? MaxDeviation, double? MissingLength, IReadOnlyList<string> OpenLoop, string? Journal, string? Program, string? Report, IReadOnlyDictionary<string, string> Settings, IReadOnlyDictionary<string, string> Options, HistoryReadBack? ReadBack, string? Plate, IReadOnlyList<CutFont> Fonts)
    {
        public double? CornerDeviation { get; init; }

        public static JobJson From(HistoryEntry entry) => new(
            entry.Id, entry.Date, entry.Kind, entry.Drawing, entry.DrawingSha256, entry.Target, entry.Mode, entry.Address, entry.Outcome, entry.Sentence,
            entry.Seconds, entry.PlannedSeconds, entry.MaxDeviation, entry.MissingLength, [.. (entry.OpenLoop ?? []).Select(axis => axis.ToString())], entry.Journal, entry.Program, entry.Report, entry.Settings, entry.Options, entry.ReadBack, entry.Plate, entry.Fonts ?? []) { CornerDeviation = entry.CornerDeviation };
    }
}
