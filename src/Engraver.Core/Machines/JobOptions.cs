using Engraver.Core.Diagnostics;
using Engraver.Core.Machines.Moves;

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

    /// <summary>The settings and the machine profile of the job as words, for the journal: whoever resumes the job must have the same.</summary>
    public IReadOnlyDictionary<string, string>? Settings { get; init; }

    /// <summary>Source position of a drawing entity, for diagnostics; null where it is not known.</summary>
    public Func<int, SourceRef>? SourceOf { get; init; }

    /// <summary>Compares what was cut with the drawing when the machine is at rest, before the journal says how the job ended; null for no comparison.</summary>
    public Func<JobResult, JobResult>? Judge { get; init; }

    /// <summary>What lies before it is cut already; the job goes on from there.</summary>
    public JobPlace From { get; init; }

    /// <summary>Journal of the interrupted job that this one goes on with; null for none. It is told so when the job begins.</summary>
    public string? ResumedJournal { get; init; }

    /// <summary>Counts of the path before <see cref="From"/> that are cut again.</summary>
    public double LeadIn { get; init; }

    /// <summary>Where an output is the tool of a machine with a Z axis: the height at which a job that is resumed was cut, the controller's own counts; the axis goes there first. Null: it is cut at the height at which the machine stands.</summary>
    public int? HeightOfCut { get; init; }

    /// <summary>Hold, resume and overrides by the operator; null for a job that nobody holds.</summary>
    public JobControl? Control { get; init; }

    /// <summary>Every motion is made, but the tool output is never switched on.</summary>
    public bool DryRun { get; init; }

    /// <summary>Software limits that the controller watches while the machine moves; those that it had are restored. Empty: they stay as they are.</summary>
    public IReadOnlyList<SoftLimit> SoftLimits { get; init; } = [];

    /// <summary>Controller counts at the drawing's zero; null: the machine stands at the drawing's start point.</summary>
    public CountsPoint? Frame { get; init; }

    /// <summary>Told what the operator must know while the job runs, on the thread of the job; null: it is among the warnings of the result.</summary>
    public Action<Diagnostic>? Told { get; init; }

    /// <summary>Told every position that was polled and differs from the one before, on the thread of the job, which it must not hold up; null for nobody.</summary>
    public Action<TracePoint>? Polled { get; init; }

    /// <summary>The controller's letters of the axes whose position error is asked for while the job runs: ten times a second over a network, with every second look at the path over a serial line. Empty where nobody needs it; steppers have none.</summary>
    public string FollowedAxes { get; init; } = "";

    /// <summary>Longest pause between two polls, on the session's clock, while the controller works on its own and no end is expected soon.</summary>
    public TimeSpan PollInterval { get; init; } = UsualPollInterval;

    /// <summary>The default, which planned times assume too.</summary>
    public static TimeSpan UsualPollInterval { get; } = TimeSpan.FromMilliseconds(10);
}

/// <summary>First line of a job in the journal.</summary>
/// <param name="StartX">_RPA when the job began.</param>
/// <param name="FrameX">Job frame: what is added to drawing counts to get the controller's.</param>
public sealed record JournalHeader(string Drawing, string Controller, JobMode Mode, int SegmentCount, long StartX, long StartY, long FrameX, long FrameY, DateTimeOffset StartedAt)
{
    public string Kind { get; } = "job";

    /// <summary>Letters of the axes of X, Y and, where there is one, Z; empty in journals of an older version.</summary>
    public string Axes { get; init; } = "";

    /// <summary>_RPA of the Z axis when the job began; 0 without one.</summary>
    public int StartZ { get; init; }

    /// <summary>What is added to heights of the drawing; 0 where an output is the tool.</summary>
    public int FrameZ { get; init; }

    /// <summary>Where an output is the tool of a machine with a Z axis: the height at which the job is cut, the controller's own counts; null elsewhere.</summary>
    public int? HeightOfCut { get; init; }

    /// <summary>By what the motion program is known again; empty in journals of an older version.</summary>
    public string Program { get; init; } = "";

    /// <summary>As in <see cref="JobOptions.Settings"/>; null in journals of an older version.</summary>
    public IReadOnlyDictionary<string, string>? Settings { get; init; }

    /// <summary>The number that the job left in a variable of the controller, which forgets it at power-off.</summary>
    public int Mark { get; init; }

    /// <summary>Nothing was cut.</summary>
    public bool DryRun { get; init; }

    /// <summary>Segments that an earlier job had cut.</summary>
    public int FromSegments { get; init; }

    /// <summary>Counts along the next one that it had cut too.</summary>
    public double FromAlong { get; init; }
}
