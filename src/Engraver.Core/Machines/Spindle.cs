namespace Engraver.Core.Machines;

/// <summary>The motor that turns the tool: switched on before the first stroke and off after the last.</summary>
public sealed record Spindle
{
    /// <summary>Digital output that switches the spindle (1 to 8).</summary>
    public int Output { get; init; } = 2;

    /// <summary>The spindle turns while the output is off.</summary>
    public bool IsActiveLow { get; init; }

    /// <summary>Time from switching it on to the first plunge, seconds.</summary>
    public double SpinUpSeconds { get; init; } = 2.0;

    /// <summary>The spindle is switched off while a job is held, after the tool has left the work; otherwise it continues to turn.</summary>
    public bool StopsInHold { get; init; }

    /// <summary>Letter of an axis that does not move and whose analog output sets the speed; null where the speed is set manually.</summary>
    public char? SpeedAxis { get; init; }

    /// <summary>Volts of that output while the spindle turns (galil-dmc.md C, OF: -9.9982 to 9.9982).</summary>
    public double SpeedVolts { get; init; }

    /// <summary>Turns per minute at these volts; null where operations cannot set the speed.</summary>
    public double? FullSpeed { get; init; }
}
