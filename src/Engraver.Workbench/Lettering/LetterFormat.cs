using Engraver.Core.Geometry;

namespace Engraver.Workbench.Lettering;

/// <summary>Size and form of letters.</summary>
/// <param name="Height">Of capital letters, drawing units.</param>
/// <param name="WidthFactor">As a multiple of the font's width.</param>
/// <param name="Oblique">Slant, clockwise positive.</param>
/// <param name="Tracking">Distance from letter to letter as a multiple of the font's.</param>
public readonly record struct LetterFormat(double Height, double WidthFactor, Angle Oblique, double Tracking)
{
    /// <summary>Letters of the font's own form.</summary>
    public static LetterFormat Upright(double height) => new(height, 1.0, Angle.Zero, 1.0);
}
