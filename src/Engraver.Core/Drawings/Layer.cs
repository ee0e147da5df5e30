namespace Engraver.Core.Drawings;

/// <summary>A layer of the drawing with the switches that decide whether it is cut by default (visible, not frozen, plottable).</summary>
public sealed record Layer(string Name, bool On, bool Frozen, bool Plot)
{
    public bool CutByDefault => On && !Frozen && Plot;
}
