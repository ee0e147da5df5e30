namespace Engraver.Core.Drawings;

/// <summary>A layer of the drawing with the switches that decide whether it is cut by default (visible, not frozen, plottable).</summary>
public sealed record Layer(string Name, bool On, bool Frozen, bool Plot)
{
    /// <summary>Colour of what is coloured by layer; an index or a true colour.</summary>
    public DrawingColour Colour { get; init; } = DrawingColour.Foreground;

    public bool CutByDefault => On && !Frozen && Plot;
}
