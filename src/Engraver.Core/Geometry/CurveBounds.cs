namespace Engraver.Core.Geometry;

/// <summary>Smallest box of a span in plan: the span is halved wherever control points are still outside the box found so far.</summary>
public static class CurveBounds
{
    /// <summary>Largest distance by which the true curve may exceed the box, as a part of the span's size.</summary>
    private const double RelativeTolerance = 1e-13;

    private const int MaxHalvings = 50;

    public static Bounds2D Including(Bounds2D box, BezierSpan span)
    {
        var hull = Hull(span);
        var slack = RelativeTolerance * (hull.Width + hull.Height + Math.Abs(hull.MinX) + Math.Abs(hull.MinY));
        return Grow(box, span, hull, slack, MaxHalvings);
    }

    /// <summary>The box of the control points; the curve cannot leave it.</summary>
    public static Bounds2D Hull(BezierSpan span)
    {
        var hull = Bounds2D.Empty;
        for (var i = 0; i <= span.Degree; i++) hull = hull.Including(span.Control(i));
        return hull;
    }

    private static Bounds2D Grow(Bounds2D box, BezierSpan span, Bounds2D hull, double slack, int halvings)
    {
        box = box.Including(span.Start).Including(span.End);
        if (halvings == 0 || box.Grown(slack).Contains(hull)) return box;
        var (first, second) = span.Halves();
        box = Grow(box, first, Hull(first), slack, halvings - 1);
        return Grow(box, second, Hull(second), slack, halvings - 1);
    }
}
