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
            Check(errors == 0 || errorsAccepted, errors == 0 ? Wording.Get("ArmingChecklist.DrawingHasNoErrors") : Wording.Get("ArmingChecklist.DrawingHas", CountText.Format(errors, "Error"), errorsAccepted ? Wording.Get("ArmingChecklist.AcceptedOperator") : Wording.Get("ArmingChecklist.CheckListsThem"))),
            Check(job.Motion.Program is { SegmentCount: > 0 }, job.Motion.Program is { SegmentCount: > 0 } program ? Wording.Get("ArmingChecklist.JobHas", CountText.Format(program.SegmentCount, "Segment")) : job.WithoutProgram),
            Check(status.Link is not null && status.State is not MachineState.Offline, status.Link is { } link ? Wording.Get("ArmingChecklist.LinkStands", link) : Wording.Get("ArmingChecklist.NoControllerConnectedCncconnect")),
            Check(status.State is MachineState.Ready or MachineState.Armed or MachineState.MotorsOff, Wording.Get("ArmingChecklist.Controller", Word(status))),
            Check(status.MotorsOn == true, status.MotorsOn == true ? Wording.Get("ArmingChecklist.MotorsOn") : Wording.Get("ArmingChecklist.MotorsOffCncmotorsOn")),
            Check(status.Limit.Length == 0, status.Limit.Length == 0 ? Wording.Get("ArmingChecklist.NoLimitHit") : Wording.Get("ArmingChecklist.HitMoveMachineOff", status.Limit)),
            Origin(job, placement),
            .. job.Findings.Where(found => found.Severity == Severity.Warning).Select(found => Warning(SettingWording.AtCommandLine(found).Message.TrimEnd('.'))),
            .. LastJob(status),
        ]);
    }

    private static ArmingCheck Origin(PreparedJob job, PlacementResult? placement)
    {
        if (placement?.Frame is not { } frame) return Check(false, placement?.Refusal is { } refused ? SettingWording.AtCommandLine(refused).Message.TrimEnd('.') : Wording.Get("ArmingChecklist.PlaceNotKnown"));
        var scale = job.Settings.Machine.Scale;
        return Check(true, Wording.Get(placement.IsAssumed ? "ArmingChecklist.ZeroAssumed" : "ArmingChecklist.ZeroLies", PointPrompt.Show(new Point2D(frame.X / scale.X, frame.Y / scale.Y))));
    }

    private static IEnumerable<ArmingCheck> LastJob(MachineStatus status)
    {
        if (status.LastOutcome is { } outcome and not JobOutcome.Complete)
            yield return Warning(Wording.Get("ArmingChecklist.LastJobOnMachine", outcome == JobOutcome.Deviated ? Wording.Get("ArmingChecklist.DidNotCutWhat") : Wording.Get("ArmingChecklist.EndedEarly"), OutcomeText.Word(outcome)));
    }

    private static ArmingCheck Warning(string sentence) => new(true, sentence + ".") { IsWarning = true };

    private static ArmingCheck Check(bool passed, string sentence) => new(passed, sentence + ".");

    private static string Word(MachineStatus status) => status.State switch
    {
        MachineState.Ready or MachineState.Armed => Wording.Get("ArmingChecklist.Ready"),
        MachineState.MotorsOff => Wording.Get("ArmingChecklist.Rest"),
        MachineState.Busy or MachineState.Fault => Wording.Get("ArmingChecklist.NotReady", status.Reason),
        MachineState.EmergencyStopOpen => Wording.Get("ArmingChecklist.HeldItsAbortInput"),
        MachineState.Running or MachineState.Stopping => Wording.Get("ArmingChecklist.RunningJob"),
        _ => Wording.Get("ArmingChecklist.NotHeardYet"),
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
