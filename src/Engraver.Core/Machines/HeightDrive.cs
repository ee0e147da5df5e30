namespace Engraver.Core.Machines;

/// <summary>How an axis moves the tool to the work and away from it. Heights are millimetres above the drawing's height 0 (the top of the work), up positive;
/// the drawing is cut below its own heights by <see cref="CutDepth"/>.</summary>
public sealed record HeightDrive
{
    /// <summary>Height of every rapid in plan.</summary>
    public double ClearanceHeight { get; init; } = 5.0;

    /// <summary>Down to this height the tool moves at rapid speed, below it at the plunge feed. Every cut is below it.</summary>
    public double RetractHeight { get; init; } = 1.0;

    /// <summary>Depth of cut below the drawn heights; 0 for a drawing whose own heights are the depths.</summary>
    public double CutDepth { get; init; }

    /// <summary>Speed straight down, mm/min; a slanting cut does not go down faster.</summary>
    public double PlungeMmPerMinute { get; init; } = 300.0;

    /// <summary>Maximum depth that one pass removes, mm: earlier passes run the same stroke higher by whole multiples of it. Null: one pass.</summary>
    public double? DepthPerPass { get; init; }

    /// <summary>Number of passes of a stroke, at least 1.</summary>
    /// <param name="deepest">The lowest cut of the stroke, mm; material is removed below height 0 only.</param>
    public int Passes(double deepest) => DepthPerPass is { } step && deepest < 0.0 ? (int)Math.Max(1.0, Math.Ceiling((-deepest / step) - 1e-9)) : 1;
}

/// <summary>An output and the level at which the device that it switches is on.</summary>
/// <param name="Output">Number of the output, from 1.</param>
/// <param name="IsActiveLow">The device is on while the output is off.</param>
public readonly record struct OutputSwitch(int Output, bool IsActiveLow = false)
{
    public static implicit operator OutputSwitch(int output) => FromInt32(output);

    /// <summary>Whether the device is on.</summary>
    /// <param name="outputs">Outputs 1 to 8, bit 0 is output 1.</param>
    public bool IsOn(int outputs) => ((outputs & (1 << (Output - 1))) != 0) != IsActiveLow;

    public static OutputSwitch FromInt32(int output) => new(output);
}

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
}
