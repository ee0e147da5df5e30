using Engraver.Core.Geometry;

namespace Engraver.App.Canvas.Picking;

/// <summary>Whether an ellipse or spline touches a box: pieces are halved while their control points leave it open.</summary>
internal static class CurveTouch
{
    private const int MostHalvings = 40;

    public static bool Touches(Bounds2D box, RationalCurve curve)
    {
        foreach (var span in curve.Spans)
        {
            if (Touches(box, span, MostHalvings)) return true;
        }

        return false;
    }

    private static bool Touches(in Bounds2D box, BezierSpan span, int halvings)
    {
        if (box.Contains(span.Start) || box.Contains(span.End)) return true;
        var hull = CurveBounds.Hull(span);
        if (hull.MinX > box.MaxX || hull.MaxX < box.MinX || hull.MinY > box.MaxY || hull.MaxY < box.MinY) return false;
        if (halvings == 0) return false;
        var (first, second) = span.Halves();
        return Touches(box, first, halvings - 1) || Touches(box, second, halvings - 1);
    }
}
