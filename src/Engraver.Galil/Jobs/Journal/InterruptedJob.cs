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
    /// <summary>Journal of the job that has gone on with this one; null for none.</summary>
    public string? ResumedBy { get; init; }

    /// <returns>Null when no job is told of.</returns>
    /// <exception cref="IOException">It cannot be read.</exception>
    /// <exception cref="UnauthorizedAccessException">It may not be read.</exception>
    public static InterruptedJob? Read(string path)
    {
        InterruptedJob? job = null;
        foreach (var line in JobJournal.ReadLines(path))
        {
            if (CrashRecovery.Kind(line) is { } kind) job = After(job, kind, line);
        }

        return job;
    }

    private static InterruptedJob? After(InterruptedJob? job, string kind, string line)
    {
        try
        {
            return (job, kind) switch
            {
                (_, "job") when JobJournal.Read<JournalHeader>(line) is { } header => new InterruptedJob(header, new JobPlace(header.FromSegments, header.FromAlong), null, null),
                (not null, "resumed") => job with { ResumedBy = JobJournal.Read<JournalResumed>(line)?.By },
                (not null, "opened") => job with { Opened = JobJournal.Read<JournalOpened>(line) },
                (not null, "progress") when JobJournal.Read<JournalProgress>(line) is { } now => job with { Place = JobPlace.Later(job.Place, new JobPlace(now.Cut, now.Along)) },
                (not null, "end") when JobJournal.Read<JournalEnd>(line) is { } end => job with { End = end, Place = JobPlace.Later(job.Place, new JobPlace(end.Cut, end.Along)) },
                _ => job,
            };
        }
        catch (JsonException)
        {
            return job; // a line of another version
        }
    }
}
