using Engraver.Core.Diagnostics;
using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Origins;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Machines.Runs;
using Engraver.Workbench.Reports;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Machines.Arming;

/// <summary>What was checked before START works, in the order in which an operator would look.</summary>
public sealed record ArmingChecklist(IReadOnlyList<ArmingCheck> Checks)
{
    public bool Passed => Checks.All(check => check.Passed);

    /// <param name="errorsAccepted">The operator has said that the drawing's errors do not matter.</param>
    /// <param name="placement">Where the job would go on this machine; null while nobody has asked it.</param>
    public static ArmingChecklist Create(PreparedJob job, MachineStatus status, bool errorsAccepted, PlacementResult? placement)
    {
        var errors = job.Diagnostics.Count(found => found.Severity == Severity.Error);
        return new ArmingChecklist(
        [
            Check(errors == 0 || errorsAccepted, errors == 0 ? "The drawing has no errors" : $"The drawing has {CountText.Format(errors, "error")}{(errorsAccepted ? ", accepted by the operator" : "; CHECK lists them")}"),
            Check(job.Motion.Program is { SegmentCount: > 0 }, job.Motion.Program is { SegmentCount: > 0 } program ? $"The job has {CountText.Format(program.SegmentCount, "segment")}" : job.WithoutProgram),
            Check(status.Link is not null && status.State is not MachineState.Offline, status.Link is { } link ? $"The link to {link} stands" : "No controller is connected; CNCCONNECT"),
            Check(status.State is MachineState.Ready or MachineState.Armed or MachineState.MotorsOff, $"The controller is {Word(status)}"),
            Check(status.MotorsOn == true, status.MotorsOn == true ? "The motors are on" : "The motors are off; CNCMOTORS ON"),
            Check(status.Limit.Length == 0, status.Limit.Length == 0 ? "No limit is hit" : $"{status.Limit} is hit; move the machine off it"),
            Origin(job, placement),
            .. job.Findings.Where(found => found.Severity == Severity.Warning).Select(found => Warning(SettingWording.AtCommandLine(found).Message.TrimEnd('.'))),
            .. LastJob(status),
        ]);
    }

    private static ArmingCheck Origin(PreparedJob job, PlacementResult? placement)
    {
        if (placement?.Frame is not { } frame) return Check(false, placement?.Refusal is { } refused ? SettingWording.AtCommandLine(refused).Message.TrimEnd('.') : "Nobody knows yet where the drawing's zero lies");
        var scale = job.Settings.Machine.Scale;
        return Check(true, $"The drawing's zero lies at {PointPrompt.Show(new Point2D(frame.X / scale.X, frame.Y / scale.Y))} mm of the machine{(placement.IsAssumed ? ", where the controller counts 0: no origin was set" : "")}");
    }

    private static IEnumerable<ArmingCheck> LastJob(MachineStatus status)
    {
        if (status.LastOutcome is { } outcome and not JobOutcome.Complete) yield return Warning($"The last job on this machine {(outcome == JobOutcome.Deviated ? "did not cut what was drawn" : "ended early")} ({OutcomeText.Word(outcome)})");
    }

    private static ArmingCheck Warning(string sentence) => new(true, sentence + ".") { IsWarning = true };

    private static ArmingCheck Check(bool passed, string sentence) => new(passed, sentence + ".");

    private static string Word(MachineStatus status) => status.State switch
    {
        MachineState.Ready or MachineState.Armed => "ready",
        MachineState.MotorsOff => "at rest",
        MachineState.Busy or MachineState.Fault => $"not ready: {status.Reason}",
        MachineState.EmergencyStopOpen => "held by its abort input; release the emergency stop",
        MachineState.Running or MachineState.Stopping => "running a job",
        _ => "not heard yet",
    };
}

/// <summary>One thing that must be so before a job may start.</summary>
/// <param name="Passed">True when it is so.</param>
/// <param name="Sentence">What was looked at, and when it is not so, what to do.</param>
public sealed record ArmingCheck(bool Passed, string Sentence)
{
    /// <summary>It does not stand in the way, but the operator must have read it.</summary>
    public bool IsWarning { get; init; }
}
