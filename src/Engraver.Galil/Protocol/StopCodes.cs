namespace Engraver.Galil.Protocol;

/// <summary>The codes of SC: why an axis stopped or is stopping (galil-dmc.md A.10).</summary>
public static class StopCodes
{
    /// <summary>The axis moves.</summary>
    public const int Running = 0;

    /// <summary>An independent move that ended at its target.</summary>
    public const int AtTarget = 1;

    public const int AbortInput = 6;

    /// <summary>AB or AB 1.</summary>
    public const int AbortCommand = 7;

    public const int SelectiveAbort = 11;

    public const int SequenceRunning = 100;

    /// <summary>A vector sequence that was ended by VE.</summary>
    public const int SequenceEnded = 101;

    /// <summary>A switch, an input or the axis' own position error stopped it, not a command.</summary>
    public static bool IsFromOutside(int code) => code is 2 or 3 or AbortInput or 8 or SelectiveAbort;

    /// <summary>The axis stopped without deceleration: a stepper can then lose steps without being detected. The code remains until the axis is moved
    /// again.</summary>
    public static bool IsWithoutRamp(int code) => code is AbortInput or AbortCommand or SelectiveAbort;

    public static string Text(int code) => code switch
    {
        Running => Wording.Get("StopCodes.Running"),
        AtTarget => Wording.Get("StopCodes.AtCommandedPosition"),
        2 => Wording.Get("StopCodes.StoppedForwardLimitSwitch"),
        3 => Wording.Get("StopCodes.StoppedReverseLimitSwitch"),
        4 => Wording.Get("StopCodes.StoppedStCommand"),
        AbortInput => Wording.Get("StopCodes.StoppedAbortInput"),
        AbortCommand => Wording.Get("StopCodes.StoppedAbCommand"),
        8 => Wording.Get("StopCodes.SwitchedOffByFollowingError"),
        SelectiveAbort => Wording.Get("StopCodes.StoppedSelectiveAbortInput"),
        SequenceRunning => Wording.Get("StopCodes.VectorSequenceRunning"),
        SequenceEnded => Wording.Get("StopCodes.VectorSequenceEnded"),
        _ => Wording.Get("StopCodes.StopCode", code),
    };
}
