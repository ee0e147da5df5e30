using Engraver.Core.Machines;
using Engraver.Core.Motion;
using Engraver.Galil.Jobs.Journal;
using Engraver.Galil.Language;

namespace Engraver.Workbench.Composition;

/// <summary>What a journal alone tells of its run, for one that the history does not know.</summary>
/// <param name="Outcome">Null where the journal has no end: the run was killed, or goes on.</param>
/// <param name="Seconds">Controller time at its end.</param>
/// <param name="Program">By what its motion program is known again (<see cref="ProgramFingerprint"/>); empty in older journals.</param>
public sealed record JournalledRun(JobOutcome? Outcome, string Sentence, double? Seconds, ExecutionStrategy Strategy, bool IsDryRun, string Program)
{
    /// <summary>Nothing is left to do: it ended, the controller was left as it was found, and it cannot be resumed.</summary>
    public bool IsSettled { get; private init; }

    /// <summary>The copy of the program that was in the controller, beside a journal.</summary>
    public static string ProgramCopyOf(string journal) => InterruptedJob.ProgramCopyOf(journal);

    /// <returns>Null where the file tells of no job, or cannot be read.</returns>
    public static JournalledRun? Read(string journal)
    {
        try
        {
            return InterruptedJob.Read(journal) is { } told ? new JournalledRun(told.End?.Outcome, told.End?.Sentence ?? "", told.End?.Time, told.Header.Mode.Strategy(), told.Header.DryRun, told.Header.Program) { IsSettled = Settled(told) } : null;
        }
        catch (Exception unreadable) when (unreadable is IOException or UnauthorizedAccessException)
        {
            return null;
        }
    }

    private static bool Settled(InterruptedJob job) => job is { End.LeftAsFound: true, WhyOver.Length: > 0 };
}
