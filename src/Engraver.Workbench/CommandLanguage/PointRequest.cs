using Engraver.Core.Geometry;

namespace Engraver.Workbench.CommandLanguage;

/// <summary>A request for a point of the drawing.</summary>
/// <param name="From">Start of the line to the point, or the first corner, drawing units; null without such a point.</param>
public sealed record PointRequest(PointPurpose Purpose, Point2D? From)
{
    /// <summary>Preview of a click at a position; null without a preview.</summary>
    public GhostFunction? Ghost { get; init; }

    /// <summary>The picked object is removed from the selection.</summary>
    public bool IsDeselecting { get; init; }

    /// <summary>Prefix of the coordinates of a click with Shift; null when Shift has no meaning.</summary>
    public string? ShiftPrefix { get; init; }

    /// <summary>A point without a base point.</summary>
    public static PointRequest Place { get; } = new(PointPurpose.Place, null);

    /// <summary>The first corner of a box.</summary>
    public static PointRequest FirstCorner { get; } = new(PointPurpose.Corner, null);
}
