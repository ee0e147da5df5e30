using Engraver.Workbench.Composition;
using Engraver.Workbench.Machines.Runs;

namespace Engraver.Cli.Output.Jobs;

/// <summary>What <c>engraver replay --json</c> prints; names, units and meanings are the runner's contract.</summary>
/// <param name="Outcome">From the journal; null if the journal has no regular end.</param>
/// <param name="Clock">controller: the times are exact; wall: those of the host.</param>
/// <param name="Whole">False if the recorded conversation is incomplete.</param>
/// <param name="Late">Maximum delay of the replay relative to the host, seconds.</param>
internal sealed record ReplayJson(
    string Journal, string? Drawing, string? Outcome, string Clock, bool Whole, int Said, int Samples, double Seconds, long? FinalX, long? FinalY, long? JournalX, long? JournalY, bool? Agrees, double Late, ReplayJson.ComparisonJson? Against)
{
    public static ReplayJson From(string journal, IncidentReplay replay, ReplayComparison? compared) => new(
        journal,
        replay.JournalledJob?.Header.Drawing,
        replay.JournalledJob?.End is { } end ? OutcomeText.Token(end.Outcome) : null,
        replay.Conversation.IsControllersClock ? "controller" : "wall",
        replay.Conversation.IsWhole,
        replay.Conversation.Steps.Count(step => step.Bytes.Length > 0),
        replay.Samples,
        replay.Seconds,
        replay.FinalPosition?.X,
        replay.FinalPosition?.Y,
        replay.JournalledJob?.End?.X,
        replay.JournalledJob?.End?.Y,
        replay.EndsAsJournalled,
        replay.LateSeconds,
        compared is null ? null : new ComparisonJson(compared.IsSame, compared.MatchingLines, compared.RecordLine, compared.ReplayLine));

    /// <param name="Lines">Number of matching lines from the start.</param>
    /// <param name="Record">First differing line of the record; null if it ends earlier or nothing differs.</param>
    /// <param name="Replay">First differing line of the replay; null if it ends earlier or nothing differs.</param>
    internal sealed record ComparisonJson(bool Same, int Lines, string? Record, string? Replay);
}
