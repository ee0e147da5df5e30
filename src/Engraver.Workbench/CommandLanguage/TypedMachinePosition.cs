using Engraver.Core.Geometry;
using Engraver.Core.Machines;

namespace Engraver.Workbench.CommandLanguage;

/// <summary>A position relative to the controller's zero, mm.</summary>
/// <param name="Z">Null if no height was given.</param>
public sealed record TypedMachinePosition(double X, double Y, double? Z = null)
{
    public Point2D XY => new(X, Y);

    /// <summary>True if the position is in the counter range of the controller.</summary>
    public bool FitsCounter(CountsScale scale) => scale.IsInRange(Bounds2D.FromCorners(XY, XY), default) && scale.IsHeightInRange(Z ?? 0.0);

    /// <summary>Counts; the height is 0 if none was given.</summary>
    public CountsPoint ToCounts(CountsScale scale) => scale.ToCounts(XY) with { Z = scale.ToHeight(Z ?? 0.0) };
}
