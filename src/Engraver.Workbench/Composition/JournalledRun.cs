using Engraver.Core.Machines;
using Engraver.Core.Motion;
using Engraver.Galil.Jobs.Journal;
using Engraver.Galil.Language;

namespace Engraver.Workbench.Composition;

/// <summary>The run in a journal that has no entry in the history.</summary>
/// <param name="Outcome">Null if the journal has no end: the run was killed or is still active.</param>
/// <param name="Seconds">Controller time at its end.</param>
/// <param name="Program">Fingerprint of its motion program (<see cref="ProgramFingerprint"/>); empty in older journals.</param>
public sealed record JournalledRun(JobOutcome? Outcome, string Sentence, double? Seconds, ExecutionStrategy Strategy, bool IsDryRun, string Program)
{
    /// <summary>True if the run ended, the controller was restored, and the run cannot be resumed.</summary>
    public bool IsClosed { get; private init; }

    /// <summary>As in <see cref="JobOptions.Settings"/>; null in older journals.</summary>
    public IReadOnlyDictionary<string, string>? Settings { get; private init; }

    /// <summary>Path of the copy of the controller's program beside a journal.</summary>
    public static string ProgramCopyOf(string journal) => InterruptedJob.ProgramCopyOf(journal);

    /// <returns>Null if the file has no job or cannot be read.</returns>
    public static JournalledRun? Read(string journal)
    {
        try
        {
            return InterruptedJob.Read(journal) is { } job ? new JournalledRun(job.End?.Outcome, job.End?.Sentence ?? "", job.End?.Time, job.Header.Mode.Strategy(), job.Header.DryRun, job.Header.Program) { IsClosed = Closed(job), Settings = job.Header.Settings } : null;
        }
        catch (Exception unreadable) when (unreadable is IOException or UnauthorizedAccessException)
        {
            return null;
        }
    }

    private static bool Closed(InterruptedJob job) => job is { End.LeftAsFound: true, NotResumableReason.Length: > 0 };
}
