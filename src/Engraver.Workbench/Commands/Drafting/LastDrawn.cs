using Engraver.Core.Drawings;
using Engraver.Core.Geometry;

namespace Engraver.Workbench.Commands.Drafting;

/// <summary>The last line or arc of the drawing, from which LINE, PLINE and ARC go on when Enter alone is given.</summary>
internal static class LastDrawn
{
    /// <summary>The last line, arc or part of an open polyline that can be seen, in the direction in which it was drawn; null when there is none.</summary>
    /// <remarks>The drawing keeps arcs counter-clockwise. One that was drawn clockwise ends at its start: the end at the last point is taken.</remarks>
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
