using Engraver.Core.Geometry;

namespace Engraver.Core.Operations;

/// <summary>Bridges of material that hold a part until it is taken out: the tool rises over them in the deepest passes.</summary>
/// <param name="Width">Of the material that remains, mm.</param>
/// <param name="Height">Above the final depth, mm; null for a tool without an axis: it is off over the tab in every pass.</param>
public sealed record PartTabs(double Width, double? Height)
{
    /// <summary>Angle of slopes unless stated otherwise, degrees.</summary>
    public const double UsualAngle = 45.0;

    /// <summary>Number of tabs of each contour, at least 1; null when <see cref="Spacing"/> determines it, or without such tabs.</summary>
    public int? Count { get; init; }

    /// <summary>Largest distance of the middles of neighbouring tabs along the path, mm, as far as sides allow; null when <see cref="Count"/> determines the
    /// number, or without such tabs.</summary>
    public double? Spacing { get; init; }

    /// <summary>Places of tabs that were picked by hand, mm; these are besides the others.</summary>
    public IReadOnlyList<Point2D> At { get; init; } = [];

    /// <summary>Largest distance of a tab from its picked place, mm.</summary>
    public double Within { get; init; } = Operation.PickedWithin;

    public TabShape Shape { get; init; }

    /// <summary>Angle of the slopes of <see cref="TabShape.Sloped"/>, degrees.</summary>
    public double AngleDegrees { get; init; } = UsualAngle;

    /// <summary>Rise of the tool beside a tab for each millimetre; infinite for straight up.</summary>
    public double Slope => Shape == TabShape.Sloped ? Math.Tan(AngleDegrees * Math.PI / 180.0) : double.PositiveInfinity;

    /// <summary>Number of tabs on a contour, besides those picked by hand.</summary>
    /// <param name="length">Length of its path, mm.</param>
    public int CountOn(double length) => Count ?? (Spacing is { } spacing ? Math.Max(1, (int)Math.Ceiling(length / spacing * (1.0 - 1e-12))) : 0);
}
