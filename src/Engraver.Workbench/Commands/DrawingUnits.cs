using Engraver.Core.Drawings;
using Engraver.Core.Geometry;

namespace Engraver.Workbench.Commands;

/// <summary>Points at the prompts are in drawing units, as the operator sees them; settings of the stages are millimetres.</summary>
internal static class DrawingUnits
{
    public static Point2D ToMillimetres(Drawing drawing, Point2D point) => new(point.X * drawing.Unit.ToMillimetres, point.Y * drawing.Unit.ToMillimetres);

    public static Point2D FromMillimetres(Drawing drawing, Point2D point) => new(point.X / drawing.Unit.ToMillimetres, point.Y / drawing.Unit.ToMillimetres);
}
