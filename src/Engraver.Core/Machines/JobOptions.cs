using Engraver.Core.Diagnostics;
using Engraver.Core.Machines.Moves;

namespace Engraver.Core.Machines;

/// <summary>How a job is run.</summary>
public sealed record JobOptions
{
    /// <summary>One of the driver's strategies; null: its default.</summary>
    public ExecutionStrategy? Strategy { get; init; }

    /// <summary>Where progress is written as JSON lines; null for no journal. The program found in the controller is kept beside it, with <c>.program.dmc</c>
    /// added to the name.</summary>
    public string? JournalPath { get; init; }

    /// <summary>The controller's address, for the journal: an unfinished journal with another address belongs to another controller.</summary>
    public string Address { get; init; } = "";

    /// <summary>Name of the drawing for the journal.</summary>
    public string DrawingName { get; init; } = "";

    /// <summary>The settings and the machine profile of the job as words, for the journal: a job that resumes this one must have the same.</summary>
    public IReadOnlyDictionary<string, string>? Settings { get; init; }

    /// <summary>Source position of a drawing entity, for diagnostics; null where it is not known.</summary>
    public Func<int, SourceRef>? SourceOf { get; init; }

    /// <summary>Compares what was cut with the drawing when the machine is at rest, before the journal records how the job ended; null for no
    /// comparison.</summary>
    public Func<JobResult, JobResult>? Judge { get; init; }

    /// <summary>Everything before it is already cut; the job continues from there.</summary>
    public JobPosition From { get; init; }

    /// <summary>Segments of the whole program, at the start of a stroke, before which a section ends: the job ends there with
    /// <see cref="SectionEnd"/>. Null: it cuts the program to its end.</summary>
    public int? Until { get; init; }

    /// <summary>The outcome of a job that reaches <see cref="Until"/> (<see cref="JobOutcomeKinds.IsSectionEnd"/>).</summary>
    public JobOutcome SectionEnd { get; init; } = JobOutcome.ToolChange;

    /// <summary>Journal of the interrupted job that this one resumes; null for none. An entry is written to it when the job begins.</summary>
    public string? ResumedJournal { get; init; }

    /// <summary>Counts of the path before <see cref="From"/> that are cut again.</summary>
    public double LeadIn { get; init; }

    /// <summary>Where an output is the tool of a machine with a Z axis: the height at which the interrupted job was cut, the controller's own counts; the axis
    /// goes there first. Null: the cut is made at the present height of the machine.</summary>
    public int? HeightOfCut { get; init; }

    /// <summary>Hold, resume and overrides by the operator; null for a job that cannot be held.</summary>
    public JobControl? Control { get; init; }

    /// <summary>Every motion is made, but the tool output is never switched on.</summary>
    public bool DryRun { get; init; }

    /// <summary>Software limits that the controller monitors while the machine moves; its previous limits are restored afterwards. Empty: its limits do not
    /// change.</summary>
    public IReadOnlyList<SoftLimit> SoftLimits { get; init; } = [];

    /// <summary>Controller counts at the drawing's zero; null: the machine is at the drawing's start point.</summary>
    public CountsPoint? Frame { get; init; }

    /// <summary>Called with what the operator must know while the job runs, on the thread of the job; null: it is only among the warnings of the
    /// result.</summary>
    public Action<Diagnostic>? Warned { get; init; }

    /// <summary>Called with every polled position that differs from the one before, on the thread of the job, which it must not delay; null for no
    /// call.</summary>
    public Action<TracePoint>? Polled { get; init; }

    /// <summary>The controller's letters of the axes whose position error is read while the job runs: ten times a second over a network, with every second poll
    /// of the path over a serial line. Empty where it is not needed; steppers have none.</summary>
    public string FollowedAxes { get; init; } = "";

    /// <summary>Longest pause between two polls, on the session's clock, while the controller works alone and no end is expected soon.</summary>
    public TimeSpan PollInterval { get; init; } = UsualPollInterval;

    /// <summary>The default, which planned times also assume.</summary>
    public static TimeSpan UsualPollInterval { get; } = TimeSpan.FromMilliseconds(10);
}
