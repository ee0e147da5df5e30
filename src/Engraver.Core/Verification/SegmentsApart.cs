using Engraver.Core.Geometry;

namespace Engraver.Core.Verification;

/// <summary>Tells segments apart whose boxes meet: curved ones are halved until their boxes part them, or are as good as straight.</summary>
internal static class SegmentsApart
{
    /// <summary>False when no place of the one is within reach of the other; true when one is, or nearly.</summary>
    /// <param name="path">A line, an arc or a curve of one span.</param>
    /// <param name="part">The same; a curve of many spans comes near everything.</param>
    public static bool MayComeNear(in Segment path, in Segment part, double reach)
    {
        if (part.IsFreeCurve && part.Curve.Spans.Length > 1) return true;
        var (first, second) = (OrientedBox.Around(path), OrientedBox.Around(part));
        if (!first.Grown(reach).Overlaps(second)) return false;
        if (Math.Max(first.HalfWidth, second.HalfWidth) <= reach) return true;
        var distance = part.DistanceTo(path.PointAt(0.5));
        if (distance <= reach) return true;
        if (!path.IsFreeCurve && distance > reach + (path.Length / 2.0)) return false; // half the path leads away from its middle
        return first.HalfWidth >= second.HalfWidth
            ? MayComeNear(SegmentPart.Of(path, 0.0, 0.5), part, reach) || MayComeNear(SegmentPart.Of(path, 0.5, 1.0), part, reach)
            : MayComeNear(path, SegmentPart.Of(part, 0.0, 0.5), reach) || MayComeNear(path, SegmentPart.Of(part, 0.5, 1.0), reach);
    }
}
