using Engraver.Core.Diagnostics;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Origins;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Machines.Runs;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Machines.Arming;

/// <summary>The start checks, in the order in which an operator would look: used by ARM, CNCARM, CNCSTATUS and the desktop.</summary>
public sealed record ArmingChecklist(IReadOnlyList<ArmingCheck> Checks)
{
    /// <summary>Maximum age of a controller status that counts as current.</summary>
    public static readonly TimeSpan MaxStatusAge = TimeSpan.FromSeconds(2);

    public bool Passed => Checks.All(check => check.Passed);

    /// <param name="errorsAccepted">The operator has accepted the errors of the drawing.</param>
    /// <param name="placement">The placement of the job on this machine; null if unknown.</param>
    /// <param name="now">Time by the clock of the status: outdated values do not pass.</param>
    /// <param name="certificate">The certificate check, with commands by their keys; null if it was not checked.</param>
    public static ArmingChecklist Create(PreparedJob job, MachineStatus status, bool errorsAccepted, PlacementResult? placement, DateTimeOffset now, ArmingCheck? certificate = null) => Create(job, status, errorsAccepted, placement, now, CheckTerminology.Desktop, certificate);

    /// <summary>The same for the console, with a status that was just polled. There is no ARM: errors of the drawing were accepted, and a job switches on
    /// motors that are off.</summary>
    /// <param name="profile">Profile of the machine on which the job was placed.</param>
    /// <param name="certificate">As for <see cref="Create(PreparedJob, MachineStatus, bool, PlacementResult, DateTimeOffset, ArmingCheck)"/>.</param>
    public static ArmingChecklist ForConsole(PreparedJob job, MachineProfile profile, MachineStatus status, PlacementResult? placement, ArmingCheck? certificate = null) =>
        Create(job with { Settings = job.Settings with { Machine = profile } }, status, errorsAccepted: true, placement, status.Time, CheckTerminology.Console, certificate);

    /// <summary>The same for a frame run with the tool off.</summary>
    /// <param name="placement">The placement of the frame.</param>
    public static ArmingChecklist ForFrameOnConsole(PreparedJob job, MachineProfile profile, MachineStatus status, PlacementResult? placement) =>
        Create(job with { Settings = job.Settings with { Machine = profile } }, status, errorsAccepted: true, placement, status.Time, CheckTerminology.Console with { StaysInside = "ArmingChecklist.FrameStaysInside" }, certificate: null);

    /// <summary>The first line that prevents the start; null if there is none.</summary>
    public string? FailureText => Checks.FirstOrDefault(check => !check.Passed)?.Message;

    /// <summary>Only the checks of the machine, without a prepared job.</summary>
    public static ArmingChecklist ForMachine(MachineStatus status, DateTimeOffset now) => new([.. OfMachine(status, now, CheckTerminology.Desktop), .. LastJob(status)]);

    private static ArmingChecklist Create(PreparedJob job, MachineStatus status, bool errorsAccepted, PlacementResult? placement, DateTimeOffset now, CheckTerminology speech, ArmingCheck? certificate) => new(
    [
        .. OfDrawing(job, errorsAccepted, speech),
        .. Values(job),
        .. certificate is null ? Array.Empty<ArmingCheck>() : [certificate with { Message = speech.ApplyTerminology(certificate.Message) }],
        .. OfMachine(status, now, speech),
        UnlessStale(status, now, Origin(job, placement, speech)),
        .. Travel(job, placement, speech).Select(check => UnlessStale(status, now, check)),
        .. Warnings(job, speech),
        .. LastJob(status),
    ]);

    private static IEnumerable<ArmingCheck> OfDrawing(PreparedJob job, bool errorsAccepted, CheckTerminology speech)
    {
        var errors = job.Diagnostics.Count(found => found.Severity == Severity.Error);
        yield return Check(errors == 0 || errorsAccepted, errors == 0 ? Wording.Get("ArmingChecklist.DrawingHasNoErrors") : speech.ApplyTerminology(Wording.Get(errorsAccepted ? "ArmingChecklist.DrawingHasAcceptedErrors" : "ArmingChecklist.DrawingHasErrors", CountText.Format(errors, "Error"))));
        yield return Check(job.Motion.Program is { SegmentCount: > 0 }, job.Motion.Program is { SegmentCount: > 0 } program ? Wording.Get("ArmingChecklist.JobSize", CountText.Format(program.SegmentCount, "Segment")) : job.NoProgramReason);
        foreach (var refused in job.RunRefusals) yield return Check(false, refused.Message.TrimEnd('.'));
    }

    private static IEnumerable<ArmingCheck> Values(PreparedJob job)
    {
        if (job.Sections is { Count: > 1 } sections && sections.Any(section => section.Tool.Number != sections[0].Tool.Number)) yield return Note(Wording.Get("ArmingChecklist.Tools", string.Join(", ", sections.Where(section => section.Repeat is null).Select(section => section.Tool.Title))));
        if (job.Plate is { } plate) yield return Note(Wording.Get("ArmingChecklist.Plate", plate.Number, plate));
    }

    private static IEnumerable<ArmingCheck> OfMachine(MachineStatus status, DateTimeOffset now, CheckTerminology speech)
    {
        yield return Link(status, now, speech);
        if (status.Link is null) yield break;
        ArmingCheck[] said =
        [
            Check(status.State.IsReady() || status.State is MachineState.MotorsOff or MachineState.NotHomed or MachineState.NoOrigin, ControllerState(status)),
            .. status.IsHomed is { } homed ? [status.HomingIsAssumed && homed ? Note(Wording.Get("ArmingChecklist.HomingAssumed")) : Check(homed, speech.Text(homed ? "ArmingChecklist.Homed" : "ArmingChecklist.NotHomed"))] : Array.Empty<ArmingCheck>(),
            status.MotorsOn == true ? Check(true, Wording.Get("ArmingChecklist.MotorsOn")) : speech.Motors(),
            Check(status.Limit.Length == 0, status.Limit.Length == 0 ? Wording.Get("ArmingChecklist.NoLimitSwitchActive") : Wording.Get("ArmingChecklist.LimitSwitchActive", status.Limit)),
            Check(status.State != MachineState.EmergencyStopOpen, Wording.Get(status.State == MachineState.EmergencyStopOpen ? "ArmingChecklist.AbortInputActive" : "ArmingChecklist.AbortInputInactive")),
        ];
        foreach (var check in said) yield return UnlessStale(status, now, check);
    }

    /// <summary>Passes only if the controller has answered recently.</summary>
    private static ArmingCheck Link(MachineStatus status, DateTimeOffset now, CheckTerminology speech)
    {
        if (status.Link is not { } link) return Check(false, speech.Text("ArmingChecklist.NoController"));
        if (status.IsLinkLost) return Check(false, speech.ApplyTerminology(Wording.Get("ArmingChecklist.LinkLost", link)));
        return IsFresh(status, now) ? Check(true, Wording.Get("ArmingChecklist.LinkUp", link)) : Check(false, speech.ApplyTerminology(Wording.Get("ArmingChecklist.NoReplyFor", link, Math.Floor((now - status.Time).TotalSeconds))));
    }

    private static bool IsFresh(MachineStatus status, DateTimeOffset now) => !status.IsLinkLost && now - status.Time <= MaxStatusAge;

    /// <summary>An outdated check counts as unknown: neither passed nor failed.</summary>
    private static ArmingCheck UnlessStale(MachineStatus status, DateTimeOffset now, ArmingCheck check) =>
        status.Link is null || IsFresh(status, now) ? check : new ArmingCheck(false, Wording.Get("ArmingChecklist.LastKnown", check.Message)) { IsCurrent = false };

    /// <summary>Warnings: assumed units, unrealistic sizes, visible but uncut entities.</summary>
    private static IEnumerable<ArmingCheck> Warnings(PreparedJob job, CheckTerminology speech) =>
        job.Drawing.Diagnostics.Where(found => found.Id == DxfRules.UnitsAssumed.Id).Concat(job.Findings.Where(found => found.Severity == Severity.Warning))
            .Select(found => Warning(speech.Finding(found).TrimEnd('.')) with { IsFinding = true });

    /// <summary>Without a check for a job that exceeds the travel: it has no placement, which the origin check reports.</summary>
    private static IEnumerable<ArmingCheck> Travel(PreparedJob job, PlacementResult? placement, CheckTerminology speech)
    {
        if (placement is { Frame: not null, IsWithinTravel: true } && job.Settings.CuttingMachine.Axes.All.Any(axis => axis.Travel is not null)) yield return Check(true, Wording.Get(speech.StaysInside));
    }

    private static ArmingCheck Origin(PreparedJob job, PlacementResult? placement, CheckTerminology speech)
    {
        if (placement?.Frame is not { } frame) return Check(false, placement?.Refusal is { } refused ? speech.Finding(refused).TrimEnd('.') : Wording.Get("ArmingChecklist.WorkOriginUnknown"));
        var machine = job.Settings.CuttingMachine;
        var scale = machine.Height is null ? machine.Scale with { Z = default } : machine.Scale; // without a tool on it the height of an axis means nothing to a job
        return Check(true, Wording.Get(placement.IsAssumed ? "ArmingChecklist.ZeroAssumed" : "ArmingChecklist.ZeroPosition", PositionText.Format(frame, scale)));
    }

    private static IEnumerable<ArmingCheck> LastJob(MachineStatus status)
    {
        if (status.LastOutcome is { } outcome && !outcome.IsAsPlanned())
            yield return Warning(outcome == JobOutcome.Deviated ? Wording.Get("ArmingChecklist.LastJobDeviated") : Wording.Get("ArmingChecklist.LastJobEndedEarly", OutcomeText.DisplayText(outcome)));
    }

    internal static ArmingCheck Warning(string sentence) => new(true, sentence + ".") { IsWarning = true };

    private static ArmingCheck Note(string sentence) => new(true, sentence + ".") { IsNote = true };

    internal static ArmingCheck Check(bool passed, string sentence) => new(passed, sentence + ".");

    private static string ControllerState(MachineStatus status) => status.State switch
    {
        _ when status.State.IsReady() => Wording.Get("ArmingChecklist.ControllerReady"),
        MachineState.MotorsOff or MachineState.NotHomed or MachineState.NoOrigin => Wording.Get("ArmingChecklist.ControllerAtRest"),
        MachineState.Busy or MachineState.Fault => Wording.Get("ArmingChecklist.ControllerNotReady", status.Reason),
        MachineState.EmergencyStopOpen => Wording.Get("ArmingChecklist.MotionBlockedByAbortInput"),
        MachineState.Moving => Wording.Get("ArmingChecklist.ControllerNotReady", status.Reason),
        _ when status.State.IsJob() => Wording.Get("ArmingChecklist.ControllerRunsJob"),
        _ => Wording.Get("ArmingChecklist.ControllerStateUnknown"),
    };
}

/// <summary>Terminology of the front end: commands of the desktop, or verbs and options of the console.</summary>
internal sealed record CheckTerminology(Func<Diagnostic, Diagnostic> Translate, Func<string, string> ApplyTerminology, bool SwitchesMotors)
{
    public static CheckTerminology Desktop { get; } = new(SettingWording.AtCommandLine, SettingWording.AtCommandLine, SwitchesMotors: false);

    public static CheckTerminology Console { get; } = new(SettingWording.OnConsole, SettingWording.OnConsole, SwitchesMotors: true);

    /// <summary>Text key of the check that the job stays inside the travel.</summary>
    public string StaysInside { get; init; } = "ArmingChecklist.StaysInside";

    /// <summary>A text with its settings and commands named for the front end.</summary>
    public string Text(string key) => ApplyTerminology(Wording.Get(key));

    public string Finding(Diagnostic found) => Translate(found).Message;

    /// <summary>The check of motors that are off.</summary>
    public ArmingCheck Motors() => SwitchesMotors ? ArmingChecklist.Warning(Wording.Get("ArmingChecklist.JobSwitchesMotorsOn")) : ArmingChecklist.Check(false, Text("ArmingChecklist.MotorsOff"));
}
