using Engraver.Core.Geometry;
using Engraver.Core.Machines;

namespace Engraver.Workbench.CommandLanguage;

/// <summary>Machine positions for display, mm: <c>x,y</c>, or <c>x,y,z</c> with a Z axis.</summary>
public static class PositionText
{
    /// <param name="at">Counts.</param>
    /// <param name="scale">Of the machine; without a Z axis the height is left out.</param>
    public static string Format(CountsPoint at, CountsScale scale) => Format(scale.ToMillimetres(at.X, at.Y), scale.Z.IsNone ? null : scale.ToMillimetres(at.Z));

    /// <param name="height">Null on a machine without a Z axis, or when unknown.</param>
    public static string Format(Point2D at, double? height) => height is { } z ? $"{PointPrompt.Format(at)},{z.ToString("0.######", System.Globalization.CultureInfo.InvariantCulture)}" : PointPrompt.Format(at);
}
