using Engraver.Core.Geometry;

namespace Engraver.Core.Verification;

/// <summary>Separates segments whose boxes meet: curved segments are halved until their boxes are separate or they are almost straight.</summary>
internal static class SegmentSeparation
{
    /// <summary>False when no place of one segment is within reach of the other; true when a place is within reach, or nearly.</summary>
    /// <param name="path">A line, an arc or a curve of one span.</param>
    /// <param name="part">The same; a curve of many spans counts as near every segment.</param>
    public static bool CanBeNear(in Segment path, in Segment part, double reach)
    {
        if (part.IsFreeCurve && part.Curve.Spans.Length > 1) return true;
        var (first, second) = (OrientedBox.Around(path), OrientedBox.Around(part));
        if (!first.Grown(reach).Overlaps(second)) return false;
        if (Math.Max(first.HalfWidth, second.HalfWidth) <= reach) return true;
        var distance = part.DistanceTo(path.PointAt(0.5));
        if (distance <= reach) return true;
        if (!path.IsFreeCurve && distance > reach + (path.Length / 2.0)) return false; // half the path extends from its middle
        return first.HalfWidth >= second.HalfWidth
            ? CanBeNear(SegmentPart.Of(path, 0.0, 0.5), part, reach) || CanBeNear(SegmentPart.Of(path, 0.5, 1.0), part, reach)
            : CanBeNear(path, SegmentPart.Of(part, 0.0, 0.5), reach) || CanBeNear(path, SegmentPart.Of(part, 0.5, 1.0), reach);
    }
}
