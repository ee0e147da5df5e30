using Engraver.Core.Geometry;

namespace Engraver.Workbench.CommandLanguage;

/// <summary>A place of the drawing that is asked for.</summary>
/// <param name="From">Where the way to it begins, or the first corner, drawing units; null when it stands alone.</param>
public sealed record PointAim(PointUse Use, Point2D? From)
{
    /// <summary>A place that stands alone.</summary>
    public static PointAim Place { get; } = new(PointUse.Place, null);

    /// <summary>The corner where a box begins.</summary>
    public static PointAim FirstCorner { get; } = new(PointUse.Corner, null);
}
