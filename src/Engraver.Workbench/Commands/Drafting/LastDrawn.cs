using Engraver.Core.Drawings;
using Engraver.Core.Geometry;

namespace Engraver.Workbench.Commands.Drafting;

/// <summary>The last line or arc of the drawing, which LINE, PLINE and ARC continue on Enter alone.</summary>
internal static class LastDrawn
{
    /// <summary>The last visible line, arc or part of an open polyline, in its drawing direction; null when there is none.</summary>
    /// <remarks>Arcs are stored counter-clockwise; the end of an arc drawn clockwise is its start. The end at the last point is used.</remarks>
    public static Segment? In(CommandContext context)
    {
        var drawing = context.Drawing;
        for (var index = drawing.Entities.Count - 1; index >= 0; index--)
        {
            if (drawing.Entities[index] is not { Hidden: false, Closed: false, PartCount: > 0, Type: CurveType.Line or CurveType.Arc or CurveType.LwPolyline or CurveType.Polyline } entity) continue;
            var last = drawing.SegmentOf(drawing.Parts[entity.FirstPart + entity.PartCount - 1]);
            if (last.IsFreeCurve) continue;
            return entity.Type == CurveType.Arc && context.LastPoint.DistanceTo(last.Start) < context.LastPoint.DistanceTo(last.End) ? last.Reversed() : last;
        }

        return null;
    }
}
