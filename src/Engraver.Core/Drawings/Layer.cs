namespace Engraver.Core.Drawings;

/// <summary>A layer of the drawing with the states that decide whether it is cut by default (on, not frozen, plotted).</summary>
public sealed record Layer(string Name, bool On, bool Frozen, bool Plot)
{
    /// <summary>Colour of content "by layer": an index or a true colour.</summary>
    public DrawingColour Colour { get; init; } = DrawingColour.Foreground;

    /// <summary>Linetype of content "by layer": index into <see cref="Drawing.Linetypes"/>.</summary>
    public int Linetype { get; init; } = Drawings.Linetype.Continuous;

    /// <summary>Lineweight of content "by layer": hundredths of a millimetre, or <see cref="Lineweight.Default"/>.</summary>
    public int Lineweight { get; init; } = Drawings.Lineweight.Default;

    /// <summary>Its objects cannot be changed until it is unlocked; they are cut, shown and snapped to like any other.</summary>
    public bool Locked { get; init; }

    public bool CutByDefault => On && !Frozen && Plot;
}
