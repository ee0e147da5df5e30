using Engraver.Core.Diagnostics;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Origins;
using Engraver.Core.Verification;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Machines.Origins;

namespace Engraver.Workbench.Machines.Runs;

/// <summary>Result of a run and its comparison with the drawing.</summary>
/// <param name="Controller">Model reported by the controller.</param>
/// <param name="PlannedSeconds">Planned from the speed profiles of the controller and the commands exchanged at standstills over this link.</param>
public sealed record MachineRunReport(JobResult Result, RunJudgement Judgement, string Controller, double PlannedSeconds)
{
    /// <summary>Position of the drawing's zero; null if unknown.</summary>
    public PlacementResult? Placement { get; init; }

    /// <summary>Those of X, Y and Z that steppers move: their polled positions are the commanded ones, not those of the motors.</summary>
    public IReadOnlyList<char> OpenLoop { get; init; } = [];

    /// <summary>Those of <see cref="OpenLoop"/> whose deviation is based on commanded positions; the record of a simulated controller contains motor
    /// positions.</summary>
    public IReadOnlyList<char> CommandedOnly => Judgement.Source == "record" ? [] : OpenLoop;

    /// <summary>Maximum allowed deviation of this run, mm: max error, counts and, for servos, the following error that the profile allows.</summary>
    public double? ToleranceMm { get; init; }

    /// <summary>The tool stayed off.</summary>
    public bool IsDryRun { get; init; }

    /// <summary>The trace of the machine; null if unknown.</summary>
    public RunTrace? Trace { get; init; }

    /// <summary>Where the machine was slower than planned; null if it cannot be compared, or for a dry run.</summary>
    public RunLag? Lag { get; init; }

    /// <summary>Path of the run's journal; null for a run that was refused before its start.</summary>
    public string? Journal { get; init; }

    /// <summary>The section that the run was to cut; null for a job of one section.</summary>
    public JobSection? Section { get; init; }

    /// <summary>The reports of the sections of the job that were run, one for each; empty for a job of one section.</summary>
    public IReadOnlyList<MachineRunReport> Sections { get; private init; } = [];

    /// <summary>Resume position; earlier parts were cut by a previous job. Null for a job from the start.</summary>
    public JobPosition? ResumedFrom { get; init; }

    /// <summary>Why the job could not be resumed; null if it was, or for a job from the start.</summary>
    public Diagnostic? ResumeRefusal { get; private init; }

    /// <summary>Why <see cref="MachineRunOptions.Starting"/> did not let the job start; null if it did.</summary>
    public Diagnostic? StartRefusal { get; private init; }

    /// <summary>Report of a job that was refused right before its start.</summary>
    internal static MachineRunReport NotBegun(Diagnostic refused, MotionProgram program, string controller, double plannedSeconds) =>
        new(JobResult.NotStarted(program.Strokes.Count, refused.Message), RunJudgement.Unknown, controller, plannedSeconds) { StartRefusal = refused };

    /// <summary>Report of a job that does not match its journal.</summary>
    internal static MachineRunReport NotResumed(Diagnostic refused, MotionProgram program, string controller) =>
        new(JobResult.NotStarted(program.Strokes.Count, refused.Message), RunJudgement.Unknown, controller, 0.0) { ResumeRefusal = refused };

    /// <summary>Report of a job that was refused because it has no placement.</summary>
    internal static MachineRunReport NotPlaced(JobPlacement placement, string controller, double plannedSeconds) =>
        new(JobResult.NotStarted(placement.Program.Strokes.Count, placement.Found.Refusal!.Message), RunJudgement.Unknown, controller, plannedSeconds) { Placement = placement.Found };

    /// <summary>The report of a job of several sections: how its last section ended, and the sums and largest values of all of them.</summary>
    /// <param name="sections">The sections that were run, in order, at least one.</param>
    internal static MachineRunReport OfSections(IReadOnlyList<MachineRunReport> sections)
    {
        if (sections is [{ Section: null } only]) return only;
        var last = sections[^1];
        return last with
        {
            Result = last.Result with
            {
                SegmentsSent = sections.Sum(one => one.Result.SegmentsSent),
                Seconds = sections.Sum(one => one.Result.Seconds),
                Underruns = sections.Sum(one => one.Result.Underruns),
                Rejected = sections.Sum(one => one.Result.Rejected),
                Holds = sections.Sum(one => one.Result.Holds),
                Diagnostics = [.. sections.SelectMany(one => one.Result.Diagnostics)],
            },
            Judgement = RunJudgement.OfSections([.. sections.Select(one => one.Judgement)]),
            PlannedSeconds = sections.Sum(one => one.PlannedSeconds),
            ToleranceMm = sections.Max(one => one.ToleranceMm),
            ResumedFrom = sections[0].ResumedFrom,
            Sections = sections,
        };
    }

    /// <summary>Why the wire trace ended before the job; null if complete or not requested.</summary>
    public string? TraceFailure { get; init; }
}
