using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Core.Offsets;

namespace Engraver.Workbench.Documents;

/// <summary>The offset of one object of a drawing, in drawing units: to the side of a point, at a distance or through the point.</summary>
internal static class EntityOffset
{
    /// <summary>Fraction of the distance to a point used to test its side: at the centre of a circle the offset through the point vanishes.</summary>
    private const double NearRadiusFraction = 1.0 - 1e-6;

    /// <param name="drawing">The drawing.</param>
    /// <param name="entity">Index of the object.</param>
    /// <param name="side">A point on the wanted side.</param>
    /// <param name="distance">Above 0; null: through the point.</param>
    /// <param name="maxErrorMm">Maximum error of the arcs that approximate an ellipse or spline.</param>
    /// <returns>Empty if the offset vanishes or the point is on the object.</returns>
    public static IReadOnlyList<OffsetLoop> Create(Drawing drawing, int entity, Point2D side, double? distance, double maxErrorMm)
    {
        var contour = ContourOf(drawing, entity);
        var options = OffsetOptions.Round(drawing.Scale.ToDrawing(maxErrorMm));
        var away = contour.Segments.Count == 0 ? 0.0 : contour.Segments.Min(segment => SegmentDistance.Measure(segment, side));
        if (!(away > 0.0)) return [];
        var (left, right) = (Through(contour, NearRadiusFraction * away, OffsetSide.Left, options), Through(contour, NearRadiusFraction * away, OffsetSide.Right, options));
        var isLeft = Away(left, side) <= Away(right, side); // The point is on the offset that passes through it.
        return Through(contour, distance ?? away, isLeft ? OffsetSide.Left : OffsetSide.Right, options);
    }

    /// <summary>Adds loops to a drawing as lines, arcs, circles and polylines, at its end.</summary>
    /// <param name="rebuilt">The drawing to extend.</param>
    /// <param name="drawing">Drawing of the source.</param>
    /// <param name="entity">The source, whose colour, height and, by default, layer are copied.</param>
    /// <param name="loops">Drawing units.</param>
    /// <param name="layer">Index of another layer; null for that of the source.</param>
    public static void Add(DrawingRebuild rebuilt, Drawing drawing, int entity, IReadOnlyList<OffsetLoop> loops, int? layer)
    {
        var like = drawing.Entities[entity];
        var (part, height) = (drawing.Parts[like.FirstPart], 0.0);
        if (!part.IsFreeCurve) height = part.C;
        if (layer is { } other) like.Layer = other;
        foreach (var loop in loops)
        {
            var type = loop.Segments is [var only] ? only.Kind switch { SegmentKind.Line => CurveType.Line, SegmentKind.Circle => CurveType.Circle, _ => CurveType.Arc } : CurveType.LwPolyline;
            rebuilt.Add(like, type, loop.Closed, [.. loop.Segments.Select(segment => PartOf(segment, height))]);
        }
    }

    private static OffsetContour ContourOf(Drawing drawing, int index)
    {
        var entity = drawing.Entities[index];
        Segment[] segments = [.. Enumerable.Range(entity.FirstPart, entity.PartCount).Select(part => drawing.SegmentOf(drawing.Parts[part]))];
        var closed = entity.Closed || (segments.Length > 0 && segments[0].Start == segments[^1].End);
        return new OffsetContour(segments, closed);
    }

    private static IReadOnlyList<OffsetLoop> Through(OffsetContour contour, double distance, OffsetSide side, OffsetOptions options) => ContourOffset.Offset([contour], distance, side, options).Loops;

    private static double Away(IReadOnlyList<OffsetLoop> loops, Point2D place) => loops.SelectMany(loop => loop.Segments).Select(segment => SegmentDistance.Measure(segment, place)).DefaultIfEmpty(double.PositiveInfinity).Min();

    private static DrawingPart PartOf(in Segment segment, double height) => segment.Kind == SegmentKind.Line
        ? DrawingPart.Line(0, segment.Start.X, segment.Start.Y, height, segment.End.X, segment.End.Y, height)
        : DrawingPart.Arc(0, segment.Arc, height);
}
