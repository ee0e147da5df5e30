using System.Text.Json;
using Engraver.Core.Machines;

namespace Engraver.Galil.Jobs.Journal;

/// <summary>What a journal tells of its last job.</summary>
/// <param name="Header">Its first line.</param>
/// <param name="Place">The last place that it tells; what lies before it was cut.</param>
/// <param name="Opened">The sequence, call or program that was begun last; null for none.</param>
/// <param name="End">Null where the job did not end properly.</param>
public sealed record InterruptedJob(JournalHeader Header, JobPlace Place, JournalOpened? Opened, JournalEnd? End)
{
    /// <summary>Where the machine was by the line that tells <see cref="Place"/>, the controller's own counts; null where it does not tell.</summary>
    public (long X, long Y)? At { get; init; }

    /// <summary>That line is the end of a job that a fault ended: an axis that could not follow stands beside the path.</summary>
    public bool IsAtFault { get; init; }

    /// <summary>Why the journal is not as it was written; empty where it is.</summary>
    public string Fault { get; private init; } = "";

    /// <summary>The journal is of an older version, whose lines have no check sums.</summary>
    public bool IsUnsealed { get; private init; }

    /// <summary>Why the journal could not be written any more while its job went on; empty where it was.</summary>
    public string GivenUp { get; private init; } = "";

    /// <summary>Why it is not resumed, whatever else a resume asks for: nothing of it is left to cut, or how far it was cut is not known. Empty where it
    /// may be.</summary>
    public string WhyOver => this switch
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

    /// <summary>Journal of the job that has gone on with this one; null for none.</summary>
    public string? ResumedBy { get; init; }

    /// <returns>Null when no job is told of.</returns>
    /// <exception cref="IOException">It cannot be read.</exception>
    /// <exception cref="UnauthorizedAccessException">It may not be read.</exception>
    public static InterruptedJob? Read(string path)
    {
        InterruptedJob? job = null;
        var check = new JournalCheck();
        foreach (var line in JobJournal.ReadLines(path))
        {
            var kind = CrashRecovery.Kind(line);
            check.Look(line, kind);
            if (kind is not null) job = After(job, kind, line);
        }

        return job is null ? null : job with { Fault = check.Fault, IsUnsealed = check.IsUnsealed };
    }

    private InterruptedJob Reached(JobPlace place, (long X, long Y)? at, bool isAtFault) => place > Place ? this with { Place = place, At = at, IsAtFault = isAtFault } : this;

    private static InterruptedJob? After(InterruptedJob? job, string kind, string line)
    {
        try
        {
            return (job, kind) switch
            {
                (_, "job") when JobJournal.Read<JournalHeader>(line) is { } header => new InterruptedJob(header, new JobPlace(header.FromSegments, header.FromAlong), null, null),
                (not null, "resumed") => job with { ResumedBy = JobJournal.Read<JournalResumed>(line)?.By },
                (not null, "givenUp") when JobJournal.Read<JournalGivenUp>(line) is { } lost => job with { GivenUp = lost.Reason },
                (not null, "opened") => job with { Opened = JobJournal.Read<JournalOpened>(line) },
                (not null, "progress") when JobJournal.Read<JournalProgress>(line) is { } now => job.Reached(new JobPlace(now.Cut, now.Along), (now.X, now.Y), isAtFault: false),
                (not null, "end") when JobJournal.Read<JournalEnd>(line) is { } end => (job with { End = end }).Reached(new JobPlace(end.Cut, end.Along), end is { X: { } x, Y: { } y } ? (x, y) : null, isAtFault: end.Outcome != JobOutcome.Stopped),
                _ => job,
            };
        }
        catch (JsonException)
        {
            return job; // a line of another version
        }
    }
}
