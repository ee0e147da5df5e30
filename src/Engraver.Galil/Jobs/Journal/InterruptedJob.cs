using System.Text.Json;
using Engraver.Core.Machines;

namespace Engraver.Galil.Jobs.Journal;

/// <summary>The last job of a journal.</summary>
/// <param name="Header">Its first line.</param>
/// <param name="Place">The last place that it states; what is before it was cut.</param>
/// <param name="Opened">The sequence, call or program that was started last; null for none.</param>
/// <param name="End">Null where the job did not end properly.</param>
public sealed record InterruptedJob(JournalHeader Header, JobPosition Place, JournalOpened? Opened, JournalEnd? End)
{
    /// <summary>Position of the machine in the line that states <see cref="Place"/>, the controller's own counts; null where the line does not state
    /// it.</summary>
    public (long X, long Y)? Position { get; init; }

    /// <summary>That line is the end of a job that a fault ended: an axis that could not follow is beside the path.</summary>
    public bool EndedByFault { get; init; }

    /// <summary>Why the journal is not as it was written; empty where it is.</summary>
    public string Fault { get; private init; } = "";

    /// <summary>The journal is of an older version, whose lines have no check sums.</summary>
    public bool IsUnsealed { get; private init; }

    /// <summary>Why the journal could no longer be written while its job continued; empty where it was written.</summary>
    public string GivenUp { get; private init; } = "";

    /// <summary>Why it cannot be resumed, whatever the settings: nothing is left to cut, or how far it was cut is not known. Empty where it
    /// can.</summary>
    public string NotResumableReason => this switch
    {
        { GivenUp: { Length: > 0 } reason } => Wording.Get("Resume.JournalIncomplete", reason),
        { Header.DryRun: true } => Wording.Get("Resume.DryRun"),
        { ResumedBy: { } later } when File.Exists(later) => Wording.Get("Resume.AlreadyResumed", later),
        { End.Outcome: JobOutcome.Complete } => Wording.Get("Resume.Complete"),
        { End: { } end } when end.Cut >= Header.SegmentCount => Wording.Get("Resume.Complete"),
        _ => "",
    };

    /// <summary>A copy of the program that was in the controller, beside a journal.</summary>
    public static string ProgramCopyOf(string journal) => CrashRecovery.CopyOf(journal);

    /// <summary>Journal of the job that has resumed this one; null for none.</summary>
    public string? ResumedBy { get; init; }

    /// <returns>Null when the journal has no job.</returns>
    /// <exception cref="IOException">It cannot be read.</exception>
    /// <exception cref="UnauthorizedAccessException">It may not be read.</exception>
    public static InterruptedJob? Read(string path)
    {
        InterruptedJob? job = null;
        var check = new JournalCheck();
        foreach (var line in JobJournal.ReadLines(path))
        {
            var kind = CrashRecovery.Kind(line);
            check.Check(line, kind);
            if (kind is not null) job = After(job, kind, line);
        }

        return job is null ? null : job with { Fault = check.Fault, IsUnsealed = check.IsUnsealed };
    }

    private InterruptedJob Reached(JobPosition place, (long X, long Y)? at, bool isAtFault) => place > Place ? this with { Place = place, Position = at, EndedByFault = isAtFault } : this;

    private static InterruptedJob? After(InterruptedJob? job, string kind, string line)
    {
        try
        {
            return (job, kind) switch
            {
                (_, "job") when JobJournal.Read<JournalHeader>(line) is { } header => new InterruptedJob(header, new JobPosition(header.FromSegments, header.FromAlong), null, null),
                (not null, "resumed") => job with { ResumedBy = JobJournal.Read<JournalResumed>(line)?.By },
                (not null, "givenUp") when JobJournal.Read<JournalGivenUp>(line) is { } lost => job with { GivenUp = lost.Reason },
                (not null, "opened") => job with { Opened = JobJournal.Read<JournalOpened>(line) },
                (not null, "progress") when JobJournal.Read<JournalProgress>(line) is { } now => job.Reached(new JobPosition(now.Cut, now.Along), (now.X, now.Y), isAtFault: false),
                (not null, "end") when JobJournal.Read<JournalEnd>(line) is { } end => (job with { End = end }).Reached(new JobPosition(end.Cut, end.Along), end is { X: { } x, Y: { } y } ? (x, y) : null, isAtFault: end.Outcome != JobOutcome.Stopped && !end.Outcome.IsSectionEnd()),
                _ => job,
            };
        }
        catch (JsonException)
        {
            return job; // a line of another version
        }
    }
}
