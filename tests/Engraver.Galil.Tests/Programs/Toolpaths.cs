using Engraver.Core.Geometry;
using Engraver.Core.Sequencing;
using Engraver.Core.Toolpaths;

namespace Engraver.Galil.Tests.Programs;

/// <summary>Toolpaths for the tests: every segment is a separate entity, counted from 0.</summary>
internal static class Toolpaths
{
    /// <summary>Table 3 of paper 001: three lines and a half circle, a closed contour in millimetres.</summary>
    public static Toolpath Paper { get; } = OfStroke(
        Line(50, 50, 150, 50), Line(150, 50, 150, 150), Arc(100, 150, 50, 0, 180), Line(50, 150, 50, 50));

    public static Segment Line(double x1, double y1, double x2, double y2) => Segment.FromLine(new Point2D(x1, y1), new Point2D(x2, y2));

    public static Segment Arc(double x, double y, double radius, double startDegrees, double sweepDegrees) =>
        Segment.FromArc(new ArcSegment(new Point2D(x, y), radius, Angle.FromDegrees(startDegrees), Angle.FromDegrees(sweepDegrees)));

    public static Toolpath OfStroke(params Segment[] segments) => OfStrokes(segments);

    public static Toolpath OfStrokes(params Segment[][] strokes)
    {
        var entity = 0;
        return new Toolpath(Point2D.Origin, strokes.Select((segments, index) =>
            new ToolpathStroke(index, segments[0].Start == segments[^1].End, segments.Select(segment => new StrokeMove(segment, entity++)).ToList())).ToList());
    }
}
