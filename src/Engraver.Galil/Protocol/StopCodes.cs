using System.Globalization;

namespace Engraver.Galil.Protocol;

/// <summary>The codes of SC: why an axis stopped or is stopping (galil-dmc.md A.10).</summary>
public static class StopCodes
{
    /// <summary>An independent move that ended at its target.</summary>
    public const int AtTarget = 1;

    public const int AbortInput = 6;

    public const int SequenceRunning = 100;

    /// <summary>A vector sequence that was ended by VE.</summary>
    public const int SequenceEnded = 101;

    public static string Text(int code) => code switch
    {
        0 => "running",
        AtTarget => "at the commanded position",
        2 => "stopped by the forward limit switch or the software limit FL",
        3 => "stopped by the reverse limit switch or the software limit BL",
        4 => "stopped by an ST command",
        AbortInput => "stopped by the abort input",
        7 => "stopped by an AB command",
        8 => "switched off because of the position error",
        11 => "stopped by a selective abort input",
        SequenceRunning => "vector sequence running",
        SequenceEnded => "vector sequence ended",
        _ => string.Create(CultureInfo.InvariantCulture, $"stop code {code}"),
    };
}
