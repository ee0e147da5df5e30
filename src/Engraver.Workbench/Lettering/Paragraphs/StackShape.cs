using Engraver.Core.Geometry;
using Engraver.Core.TextMarkup;

namespace Engraver.Workbench.Lettering.Paragraphs;

/// <summary>Where the two texts of a stack are. The baseline of the lower one is y = 0. AutoCAD writes the size of a stack as a height before it
/// (\H0.7x;\S1/2;), so both texts have the height that is valid there.</summary>
/// <param name="size">Height of the letters.</param>
internal sealed class StackShape(MTextStackKind kind, double size, double upperAdvance, double lowerAdvance)
{
    /// <summary>Between the two texts, as a multiple of their height; the bar of a fraction is in its middle.</summary>
    private const double Gap = 0.4;

    /// <summary>Of the bar of a diagonal fraction from its lower to its upper end, as a multiple of the height.</summary>
    private const double Lean = 1.0;

    /// <summary>As a multiple of the height.</summary>
    private double Raise => kind == MTextStackKind.Diagonal ? 1.0 : 1.0 + Gap;

    public double UpperBaseline => Raise * size;

    /// <summary>From the lower baseline to the top of the upper text.</summary>
    public double Height => UpperBaseline + size;

    public double Advance => kind == MTextStackKind.Diagonal ? upperAdvance + lowerAdvance : Math.Max(upperAdvance, lowerAdvance);

    /// <summary>The texts of a fraction are centred, those of a tolerance begin at the left.</summary>
    public double UpperLeft => kind == MTextStackKind.Horizontal ? (Advance - upperAdvance) / 2.0 : 0.0;

    public double LowerLeft => kind switch
    {
        MTextStackKind.Horizontal => (Advance - lowerAdvance) / 2.0,
        MTextStackKind.Diagonal => upperAdvance,
        _ => 0.0,
    };

    public IReadOnlyList<LayoutRule> Bars => kind switch
    {
        MTextStackKind.Horizontal => [new LayoutRule(new Point2D(0.0, Height / 2.0), new Point2D(Advance, Height / 2.0))],
        MTextStackKind.Diagonal => [new LayoutRule(new Point2D(upperAdvance - (Lean * size / 2.0), 0.0), new Point2D(upperAdvance + (Lean * size / 2.0), Height))],
        _ => [],
    };
}
