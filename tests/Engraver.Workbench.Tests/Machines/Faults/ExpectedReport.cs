using Engraver.Core.Machines;
using Engraver.Simulator;
using Engraver.Workbench.Machines;

namespace Engraver.Workbench.Tests.Machines.Faults;

/// <summary>The expected reports of a fault: the result of the activity, and the machine's status at rest.</summary>
internal static class ExpectedReport
{
    /// <summary>Why the message of an activity does not report its fault; empty if it does.</summary>
    public static string Mismatch(FaultCase one, FaultyRun run) =>
        run.Result is { Outcome: JobOutcome.Complete } or { Outcome: JobOutcome.Stopped } || WordsFor(one.Fault.Kind).Any(word => run.Sentence.Contains(word, StringComparison.OrdinalIgnoreCase))
            ? ""
            : $"its sentence does not tell of {one.Fault.Kind}";

    /// <summary>The expected state according to the controller and the result of the activity, with words of its reason; in order of precedence.</summary>
    public static (MachineState State, IReadOnlyList<string> Words) StateOf(FaultCase one, FaultyRun run, MachineTruth truth, MachineStatus status) => truth switch
    {
        { Abort: true } => (MachineState.EmergencyStopOpen, ["abort input"]),
        { Limits.Length: > 0 } => (MachineState.Fault, ["limit", .. Names(truth.Limits).Select(name => $"axis {name}")]),
        { OffByError.Length: > 0 } => (MachineState.Fault, ["following error", Names(truth.OffByError)]),
        { Off.Length: > 0 } => (MachineState.MotorsOff, [Names(truth.Off)]),
        _ when status.IsHomed == false => (MachineState.NotHomed, []),
        _ when one.IsRun && run.Result is { FrameOrigin: not null, Outcome: var outcome } => outcome switch
        {
            JobOutcome.Complete => (MachineState.Complete, []),
            JobOutcome.Deviated => (MachineState.Deviated, []),
            JobOutcome.LinkLost => (MachineState.Stopped, ["connection lost"]),
            JobOutcome.Stopped => (MachineState.Stopped, ["operator"]),
            _ => (MachineState.Stopped, ["refused"]),
        },
        _ when status.OriginMissing is not null => (MachineState.NoOrigin, []),
        _ => (MachineState.Ready, []),
    };

    /// <summary>Displayed names of axes A, B and C.</summary>
    private static string Names(string letters) => string.Concat(letters.Select(letter => "XYZ"[letter - 'A']));

    private static string[] WordsFor(FaultKind kind) => kind switch
    {
        FaultKind.LimitSwitch => ["limit switch"],
        FaultKind.AbortInput => ["abort input"],
        FaultKind.MotorOff => ["motor", "switched off because of the following error"],
        FaultKind.Jam => ["following error", "could not follow", "what blocks"],
        FaultKind.Reset or FaultKind.PowerCycle => ["closed the connection", "link", "switched off or reset"],
        FaultKind.Delay or FaultKind.DropCommand or FaultKind.DropReply => ["did not reply", "link is too slow", "received nothing"],
        _ => ["replied", "did not reply"],
    };
}
