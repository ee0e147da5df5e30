using Engraver.Core.Geometry;

namespace Engraver.Core.Verification;

/// <summary>A part of a segment between two fractions (see <see cref="Segment.PointAt"/>).</summary>
internal static class SegmentPart
{
    /// <param name="segment">A line, an arc, a circle or a curve of one span.</param>
    public static Segment Of(in Segment segment, double from, double to)
    {
        if (from <= 0.0 && to >= 1.0) return segment;
        if (segment.Kind == SegmentKind.Line) return Segment.FromLine(segment.PointAt(from), segment.PointAt(to));
        if (segment.IsFreeCurve) return Segment.FromCurve(new RationalCurve(segment.Kind, [segment.Curve.Spans[0].Part(from, to)]));
        var arc = segment.Arc;
        return Segment.FromArc(new ArcSegment(arc.Centre, arc.Radius, arc.Start + (arc.Sweep * from), arc.Sweep * (to - from)));
    }
}
