using Engraver.Core.Diagnostics;

namespace Engraver.Core.Machines;

/// <summary>How a job is run.</summary>
public sealed record JobOptions
{
    public JobMode Mode { get; init; } = JobMode.Stream;

    /// <summary>Where progress is written as JSON lines, or null for nowhere. The program found in the controller is kept beside it, with <c>.program.dmc</c> added to the name.</summary>
    public string? JournalPath { get; init; }

    /// <summary>The controller's address, for the journal: an unfinished journal with another address belongs to another controller.</summary>
    public string Address { get; init; } = "";

    /// <summary>Name of the drawing for the journal.</summary>
    public string DrawingName { get; init; } = "";

    /// <summary>Source position of a drawing entity, for diagnostics; null where it is not known.</summary>
    public Func<int, SourceRef>? SourceOf { get; init; }

    /// <summary>Compares what was cut with the drawing when the machine is at rest, before the journal says how the job ended; null for no comparison.</summary>
    public Func<JobResult, JobResult>? Judge { get; init; }

    /// <summary>Every motion is made, but the tool output is never switched on.</summary>
    public bool DryRun { get; init; }

    /// <summary>Controller counts at the drawing's zero; null: the machine stands at the drawing's start point.</summary>
    public CountsPoint? Frame { get; init; }

    /// <summary>Whether every polled position is kept for a later comparison. If not, only the last ones are, and memory does not grow with the time of the run.</summary>
    public bool KeepsPolledTrace { get; init; } = true;

    /// <summary>Longest pause between two polls, on the session's clock, while the controller works on its own and no end is expected soon.</summary>
    public TimeSpan PollInterval { get; init; } = UsualPollInterval;

    /// <summary>The default, which planned times assume too.</summary>
    public static TimeSpan UsualPollInterval { get; } = TimeSpan.FromMilliseconds(10);
}

/// <summary>First line of a job in the journal.</summary>
/// <param name="StartX">_RPA when the job began.</param>
/// <param name="FrameX">Job frame: what is added to drawing counts to get the controller's.</param>
public sealed record JournalHeader(string Drawing, string Controller, JobMode Mode, int SegmentCount, int StartX, int StartY, int FrameX, int FrameY, DateTimeOffset StartedAt)
{
    public string Kind { get; } = "job";
}
