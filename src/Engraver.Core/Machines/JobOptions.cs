using Engraver.Core.Diagnostics;

namespace Engraver.Core.Machines;

/// <summary>How a job is run.</summary>
public sealed record JobOptions
{
    public JobMode Mode { get; init; } = JobMode.Stream;

    /// <summary>Where progress is written as JSON lines, or null for nowhere. The program found in the controller is kept beside it, with <c>.program.dmc</c> added to the name.</summary>
    public string? JournalPath { get; init; }

    /// <summary>Where the controller is reached, for the journal: an unfinished journal of another address is none of this controller.</summary>
    public string Address { get; init; } = "";

    /// <summary>Name of the drawing for the journal.</summary>
    public string DrawingName { get; init; } = "";

    /// <summary>Where a drawing entity stands in its file, for diagnostics; null where nobody knows.</summary>
    public Func<int, SourceRef>? SourceOf { get; init; }

    /// <summary>Holds what was cut against the drawing when the machine rests, before the journal says how the job ended; null where nobody judges.</summary>
    public Func<JobResult, JobResult>? Judge { get; init; }

    /// <summary>Every motion is made, but the tool output is never switched on.</summary>
    public bool DryRun { get; init; }

    /// <summary>Called once when the job stands ready, after the journal has it and before anything moves; it must not take long, for the watchdog runs. Null for nobody.</summary>
    public Action<JournalHeader>? Begins { get; init; }

    /// <summary>Controller counts at the drawing's zero; null: the machine stands at the drawing's start point.</summary>
    public CountsPoint? Frame { get; init; }

    /// <summary>Told where the frame of the job lies, counts of the controller at the drawing's zero, before anything moves; null for nobody.</summary>
    public Action<CountsPoint>? FrameTaken { get; init; }

    /// <summary>Whether every polled position is kept for a judge. Without, only the last ones are, and memory does not grow with the time of the run.</summary>
    public bool KeepsPolledTrace { get; init; } = true;

    /// <summary>The longest pause between two polls, by the session's clock: while the controller works on its own and nothing can have ended yet, or for long does not.</summary>
    public TimeSpan PollInterval { get; init; } = UsualPollInterval;

    /// <summary>As planned times take it.</summary>
    public static TimeSpan UsualPollInterval { get; } = TimeSpan.FromMilliseconds(10);
}

/// <summary>First line of a job in the journal.</summary>
/// <param name="StartX">_RPA when the job began.</param>
/// <param name="FrameX">Job frame: what was added to drawing counts to get the controller's.</param>
public sealed record JournalHeader(string Drawing, string Controller, JobMode Mode, int SegmentCount, int StartX, int StartY, int FrameX, int FrameY, DateTimeOffset StartedAt)
{
    public string Kind { get; } = "job";
}
