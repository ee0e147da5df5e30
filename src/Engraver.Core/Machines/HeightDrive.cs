namespace Engraver.Core.Machines;

/// <summary>How an axis brings the tool to the work and takes it away. Heights are millimetres over the drawing's height 0 (the top of the work), up positive; the drawing is cut as deep below its own heights as <see cref="CutDepth"/>.</summary>
public sealed record HeightDrive
{
    /// <summary>Height of every rapid in plan.</summary>
    public double ClearanceHeight { get; init; } = 5.0;

    /// <summary>Down to this height the tool travels fast, below it at the plunge feed. Whatever is cut lies below it.</summary>
    public double RetractHeight { get; init; } = 1.0;

    /// <summary>How far below the drawn heights the tool goes; 0 for a drawing whose own heights are the depths.</summary>
    public double CutDepth { get; init; }

    /// <summary>Speed straight down, mm/min; a slanting cut goes down no faster.</summary>
    public double PlungeMmPerMinute { get; init; } = 300.0;

    /// <summary>How much a pass takes off at most, mm: earlier passes run the same stroke higher by whole multiples of it. Null: one pass.</summary>
    public double? DepthPerPass { get; init; }

    /// <summary>Number of passes of a stroke, at least 1.</summary>
    /// <param name="deepest">Its lowest cut, mm; work is taken off below height 0 only.</param>
    public int Passes(double deepest) => DepthPerPass is { } step && deepest < 0.0 ? (int)Math.Max(1.0, Math.Ceiling((-deepest / step) - 1e-9)) : 1;
}

/// <summary>An output and the level at which what it switches is on.</summary>
/// <param name="Output">From 1.</param>
/// <param name="IsActiveLow">On while the output is off.</param>
public readonly record struct OutputSwitch(int Output, bool IsActiveLow = false)
{
    public static implicit operator OutputSwitch(int output) => FromInt32(output);

    /// <summary>Whether what it switches is on.</summary>
    /// <param name="outputs">Outputs 1 to 8, bit 0 is output 1.</param>
    public bool IsOn(int outputs) => ((outputs & (1 << (Output - 1))) != 0) != IsActiveLow;

    public static OutputSwitch FromInt32(int output) => new(output);
}

/// <summary>The motor that turns the tool: switched on before the first stroke and off behind the last.</summary>
public sealed record Spindle
{
    /// <summary>Digital output that switches it (1 to 8).</summary>
    public int Output { get; init; } = 2;

    /// <summary>The spindle turns while the output is off.</summary>
    public bool IsActiveLow { get; init; }

    /// <summary>Time from switching it on to the first plunge, seconds.</summary>
    public double SpinUpSeconds { get; init; } = 2.0;

    /// <summary>The spindle is switched off while a job is held, once the tool is out of the work; otherwise it turns on.</summary>
    public bool StopsInHold { get; init; }

    /// <summary>Letter of an axis that moves nothing and whose analog output sets the speed; null where the speed is set by hand.</summary>
    public char? SpeedAxis { get; init; }

    /// <summary>Volts of that output while the spindle turns (galil-dmc.md C, OF: -9.9982 to 9.9982).</summary>
    public double SpeedVolts { get; init; }
}
