using Engraver.Core.Geometry;

namespace Engraver.Core.Offsets;

/// <summary>The outside of a corner with a mitre or a bevel.</summary>
internal static class OffsetCorner
{
    /// <summary>The tip where both sides meet when extended straight; null when it is beyond the mitre limit or no mitre is requested.</summary>
    /// <param name="corner">Corner of the source.</param>
    /// <param name="leaving">Direction of travel before it, length 1.</param>
    /// <param name="arriving">Direction after it; turned to the right.</param>
    /// <param name="distance">Offset distance, to the left.</param>
    /// <param name="options">Join and limit.</param>
    public static Point2D? Mitre(Point2D corner, Vector2D leaving, Vector2D arriving, double distance, OffsetOptions options)
    {
        if (options.Join != OffsetJoin.Mitre) return null;
        var twiceSquaredCosine = 1.0 + leaving.Dot(arriving); // cosine of half the turn
        if (twiceSquaredCosine * options.MitreLimit * options.MitreLimit < 2.0 * (1.0 - 1e-12)) return null;
        return corner + (new Vector2D(-(leaving.Y + arriving.Y), leaving.X + arriving.X) * (distance / twiceSquaredCosine));
    }
}
