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
