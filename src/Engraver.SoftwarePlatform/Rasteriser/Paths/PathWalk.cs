using Avalonia;

namespace Engraver.SoftwarePlatform.Rasteriser.Paths;

/// <summary>Goes through a path as straight lines; curves are divided evenly in their parameter until they are within the tolerance.</summary>
internal static class PathWalk
{
    private const int MaxSteps = 200;

    /// <param name="tolerance">Largest distance of the lines from the curve, in units after the transform.</param>
    public static void Walk<TSink>(VectorPath path, in Matrix transform, double tolerance, ref TSink sink)
        where TSink : struct, IPolylineSink
    {
        var points = path.Points;
        var next = 0;
        Vector last = default, start = default;
        foreach (var verb in path.Verbs)
        {
            switch (verb)
            {
                case PathVerb.Move:
                    last = start = Transformed(points[next++], transform);
                    sink.MoveTo(last.X, last.Y);
                    break;
                case PathVerb.Line:
                    last = Transformed(points[next++], transform);
                    sink.LineTo(last.X, last.Y);
                    break;
                case PathVerb.Cubic:
                    var end = Transformed(points[next + 2], transform);
                    WalkCubic(last, Transformed(points[next], transform), Transformed(points[next + 1], transform), end, tolerance, ref sink);
                    last = end;
                    next += 3;
                    break;
                default:
                    sink.Close();
                    last = start;
                    break;
            }
        }
    }

    private static void WalkCubic<TSink>(Vector a, Vector b, Vector c, Vector d, double tolerance, ref TSink sink)
        where TSink : struct, IPolylineSink
    {
        var steps = StepsFor(a, b, c, d, tolerance);
        for (var i = 1; i < steps; i++)
        {
            double t = (double)i / steps, u = 1 - t;
            double wa = u * u * u, wb = 3 * u * u * t, wc = 3 * u * t * t, wd = t * t * t;
            sink.LineTo(a.X * wa + b.X * wb + c.X * wc + d.X * wd, a.Y * wa + b.Y * wb + c.Y * wc + d.Y * wd);
        }
        sink.LineTo(d.X, d.Y);
    }

    /// <summary>Number of chords of a cubic, whose distance from them is at most 3/4 of its largest second difference, divided by the square of that
    /// number.</summary>
    private static int StepsFor(Vector a, Vector b, Vector c, Vector d, double tolerance)
    {
        var first = a - b * 2 + c;
        var second = b - c * 2 + d;
        var bend = Math.Sqrt(Math.Max(first.SquaredLength, second.SquaredLength));
        var steps = Math.Ceiling(Math.Sqrt(bend * 0.75 / tolerance));
        return steps >= 1 ? (int)Math.Min(steps, MaxSteps) : 1;
    }

    private static Vector Transformed(Point point, in Matrix transform) =>
        new(point.X * transform.M11 + point.Y * transform.M21 + transform.M31, point.X * transform.M12 + point.Y * transform.M22 + transform.M32);
}
