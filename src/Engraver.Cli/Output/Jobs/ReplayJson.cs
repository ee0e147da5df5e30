using Engraver.Workbench.Composition;
using Engraver.Workbench.Machines.Runs;

namespace Engraver.Cli.Output.Jobs;

/// <summary>What <c>engraver replay --json</c> prints; names, units and meanings are the runner's contract.</summary>
/// <param name="Outcome">As the journal tells it; null where the job did not end in order.</param>
/// <param name="Clock">controller: the times are exact; wall: those of the host.</param>
/// <param name="Whole">False where the host did not come to the end of the conversation.</param>
/// <param name="Late">Seconds by which the replay was behind the host, at most.</param>
internal sealed record ReplayJson(
    string Journal, string? Drawing, string? Outcome, string Clock, bool Whole, int Said, int Samples, double Seconds, long? FinalX, long? FinalY, long? JournalX, long? JournalY, bool? Agrees, double Late, ReplayJson.AgainstJson? Against)
{
    public static ReplayJson From(string journal, IncidentReplay replay, ReplayComparison? compared) => new(
        journal,
        replay.Told?.Header.Drawing,
        replay.Told?.End is { } end ? OutcomeText.Word(end.Outcome) : null,
        replay.Conversation.IsControllersClock ? "controller" : "wall",
        replay.Conversation.IsWhole,
        replay.Conversation.Steps.Count(step => step.Bytes.Length > 0),
        replay.Samples,
        replay.Seconds,
        replay.FinalPosition?.X,
        replay.FinalPosition?.Y,
        replay.Told?.End?.X,
        replay.Told?.End?.Y,
        replay.Agrees,
        replay.LateSeconds,
        compared is null ? null : new AgainstJson(compared.IsSame, compared.Same, compared.There, compared.Here));

    /// <param name="Lines">From the beginning that are the same.</param>
    /// <param name="Record">The first other line of the record; null where it ends before, or nothing differs.</param>
    /// <param name="Replay">The same of the replay.</param>
    internal sealed record AgainstJson(bool Same, int Lines, string? Record, string? Replay);
}
