using Engraver.Core.Drawings;
using Engraver.Core.Geometry;

namespace Engraver.Workbench.Commands.Drafting;

/// <summary>A new curve at height 0, drawing units.</summary>
internal sealed record NewCurve(CurveType Type, bool Closed, IReadOnlyList<Segment> Segments)
{
    /// <summary>A single segment. Arcs are counter-clockwise, as in DXF.</summary>
    public static NewCurve From(Segment segment) => segment.Kind switch
    {
        SegmentKind.Line => new(CurveType.Line, false, [segment]),
        SegmentKind.Circle => new(CurveType.Circle, true, [segment]),
        SegmentKind.Arc => new(CurveType.Arc, false, [segment.Arc.Sweep.Degrees < 0.0 ? segment.Reversed() : segment]),
        _ => new(segment.Kind == SegmentKind.Ellipse ? CurveType.Ellipse : CurveType.Spline, segment.IsClosed, [segment]),
    };

    /// <summary>Connected lines and arcs.</summary>
    public static NewCurve Polyline(IReadOnlyList<Segment> segments, bool closed) => new(CurveType.LwPolyline, closed, segments);
}
