using Avalonia;
using Avalonia.Media;
using Engraver.SoftwarePlatform.Rasteriser.Paths;

namespace Engraver.SoftwarePlatform.Geometry;

/// <summary>Queries about paths that need no drawing.</summary>
internal static class PathMeasure
{
    private const double BoundsTolerance = 0.02;

    /// <summary>Smallest box around the figures; an empty one at the origin for an empty path.</summary>
    public static Rect Bounds(VectorPath path)
    {
        var outline = new VectorPath();
        foreach (var figure in PathFlattener.Flatten(path, Matrix.Identity, BoundsTolerance))
        {
            foreach (var point in figure.Points)
                outline.MoveTo(new Point(point.X, point.Y));
        }
        return outline.ControlBounds(Matrix.Identity) ?? default;
    }

    /// <summary>Largest distance from the figure at which a pen draws.</summary>
    public static double Reach(IPen pen)
    {
        var half = pen.Thickness / 2;
        var corner = pen.LineJoin == PenLineJoin.Miter ? half * Math.Max(1, pen.MiterLimit) : half;
        return pen.LineCap == PenLineCap.Square ? Math.Max(corner, half * Math.Sqrt(2)) : corner;
    }

    /// <summary>Counts the crossings of a ray to the right; open figures are closed by a straight line.</summary>
    public static bool Contains(VectorPath path, Point point, double tolerance)
    {
        var winding = 0;
        foreach (var figure in PathFlattener.Flatten(path, Matrix.Identity, tolerance))
        {
            for (var i = 0; i < figure.Points.Count; i++)
                winding += Crossing(figure.Points[i], figure.Points[(i + 1) % figure.Points.Count], point);
        }
        return path.FillRule == FillRule.EvenOdd ? winding % 2 != 0 : winding != 0;
    }

    private static int Crossing(Vector start, Vector end, Point point)
    {
        if (start.Y <= point.Y == end.Y <= point.Y)
            return 0;
        var x = start.X + (point.Y - start.Y) / (end.Y - start.Y) * (end.X - start.X);
        if (x <= point.X)
            return 0;
        return end.Y > start.Y ? 1 : -1;
    }
}
