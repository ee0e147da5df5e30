using Engraver.App.Texts;
using Engraver.Workbench.Machines;

namespace Engraver.App.MachineStrip;

/// <summary>Why a key of the strip is disabled, as the key of two texts: <c>KeyReason.KEY</c> in one or two words, <c>KeyReason.KEY.Tip</c> in a sentence
/// with what to do. Null: it is enabled.</summary>
internal static class KeyReasons
{
    /// <summary>ARM is also enabled where it only reports a missing condition and what to do.</summary>
    public static string? Arm(MachineStatus status) => status.State switch
    {
        MachineState.Armed => "Armed",
        MachineState.NoOrigin or MachineState.NotHomed or MachineState.MotorsOff => null,
        var state when state.IsReady() => null,
        _ => CommonReason(status),
    };

    public static string? Start(MachineStatus status) => status.State switch
    {
        MachineState.Armed or MachineState.Held => null,
        _ => CommonReason(status) ?? "NotArmed",
    };

    public static string? Hold(MachineStatus status) => status.State is MachineState.Running or MachineState.DryRun ? null : "NoJob";

    /// <summary>Empty for null.</summary>
    public static string ShortOf(string? reason) => reason is null ? "" : Text.Get("KeyReason." + reason);

    /// <param name="otherwise">The text while the key is enabled.</param>
    public static string TipOf(string? reason, string otherwise, MachineStatus status) => reason is null ? Text.Get(otherwise) : Text.Get("KeyReason." + reason + ".Tip", status.Reason.TrimEnd('.'));

    /// <summary>The reasons that disable both ARM and START.</summary>
    private static string? CommonReason(MachineStatus status) => status.State switch
    {
        MachineState.Offline => "NoController",
        MachineState.Connected => "Connecting",
        MachineState.Moving or MachineState.Busy => "Moving",
        MachineState.Fault => "Fault",
        MachineState.EmergencyStopOpen => "EmergencyStopOpen",
        var state when state.IsJob() => "JobRunning",
        _ => null,
    };
}
