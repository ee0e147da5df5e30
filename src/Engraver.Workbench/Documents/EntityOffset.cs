using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Core.Offsets;

namespace Engraver.Workbench.Documents;

/// <summary>The offset of one object of a drawing, in drawing units: to the side on which a place lies, at a distance or through the place.</summary>
internal static class EntityOffset
{
    /// <summary>Part of the way to a place at which its side is asked for: in the middle of a circle nothing of the offset through it would be left.</summary>
    private const double NearlyThrough = 1.0 - 1e-6;

    /// <param name="drawing">The drawing.</param>
    /// <param name="entity">Index of the object.</param>
    /// <param name="side">A place on the wanted side.</param>
    /// <param name="distance">Above 0; null: through the place.</param>
    /// <param name="maxErrorMm">Of the arcs that stand for an ellipse or spline.</param>
    /// <returns>Nothing where nothing is left, or where the place lies on the object.</returns>
    public static IReadOnlyList<OffsetLoop> Create(Drawing drawing, int entity, Point2D side, double? distance, double maxErrorMm)
    {
        var contour = ContourOf(drawing, entity);
        var options = OffsetOptions.Default with { MaxErrorMm = drawing.Scale.ToDrawing(maxErrorMm) };
        var away = contour.Segments.Count == 0 ? 0.0 : contour.Segments.Min(segment => SegmentDistance.Measure(segment, side));
        if (!(away > 0.0)) return [];
        var (left, right) = (Through(contour, NearlyThrough * away, OffsetSide.Left, options), Through(contour, NearlyThrough * away, OffsetSide.Right, options));
        var isLeft = Away(left, side) <= Away(right, side); // the place lies on the offset of its side that goes through it
        return Through(contour, distance ?? away, isLeft ? OffsetSide.Left : OffsetSide.Right, options);
    }

    /// <summary>Adds loops to a drawing as lines, arcs, circles and polylines, behind all that is there.</summary>
    /// <param name="rebuilt">Into which they go.</param>
    /// <param name="drawing">Of the source.</param>
    /// <param name="entity">The source: colour, height and, without another one, layer are taken from it.</param>
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
