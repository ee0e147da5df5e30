using Engraver.Core.Geometry;

namespace Engraver.App.Canvas.Flattening;

/// <summary>An ellipse or spline as chords that deviate from it by less than <see cref="ArcFlattener.FlatnessPixels"/>: rational Bezier spans in pixels,
/// halved until their control points are that close to the chord.</summary>
/// <remarks>All weights are positive, so that a span is inside the convex hull of its control points: a hull outside the clip is skipped, a flat hull is a
/// chord.</remarks>
internal static class CurveFlattener
{
    private const int Stride = 3;
    private const int MaxHalvings = 44;

    public static void Flatten<TSink>(RationalCurve curve, in PixelFrame frame, in Bounds2D clip, ref TSink sink)
        where TSink : struct, IChordSink
    {
        foreach (var span in curve.Spans) Flatten(span, frame, clip, ref sink);
    }

    private static void Flatten<TSink>(BezierSpan span, in PixelFrame frame, in Bounds2D clip, ref TSink sink)
        where TSink : struct, IChordSink
    {
        Span<double> points = stackalloc double[(span.Degree + 1) * Stride];
        ToPixels(span, frame, points);
        Divide(points, clip, MaxHalvings, ref sink);
    }

    /// <summary>Homogeneous coordinates in pixels; the centre of the view is subtracted before scaling, to keep precision.</summary>
    private static void ToPixels(BezierSpan span, in PixelFrame frame, Span<double> points)
    {
        var source = span.Homogeneous;
        for (var i = 0; i <= span.Degree; i++)
        {
            var weight = source[(i * BezierSpan.Stride) + 3];
            points[i * Stride] = ((source[i * BezierSpan.Stride] - (frame.CentreX * weight)) * frame.Scale) + (frame.MiddleX * weight);
            points[(i * Stride) + 1] = (((frame.CentreY * weight) - source[(i * BezierSpan.Stride) + 1]) * frame.Scale) + (frame.MiddleY * weight);
            points[(i * Stride) + 2] = weight;
        }
    }

    private static void Divide<TSink>(Span<double> points, in Bounds2D clip, int halvings, ref TSink sink)
        where TSink : struct, IChordSink
    {
        if (IsHidden(points, clip)) return;
        if (halvings == 0 || IsFlat(points))
        {
            var last = points[^Stride..];
            sink.Chord(points[0] / points[2], points[1] / points[2], last[0] / last[2], last[1] / last[2]);
            return;
        }

        Span<double> first = stackalloc double[points.Length];
        Halve(points, first);
        Divide(first, clip, halvings - 1, ref sink);
        Divide(points, clip, halvings - 1, ref sink);
    }

    /// <summary>De Casteljau at one half: the left half goes to <paramref name="first"/>, the right half stays.</summary>
    private static void Halve(Span<double> points, Span<double> first)
    {
        var count = points.Length / Stride;
        for (var level = 0; level < count; level++)
        {
            points[..Stride].CopyTo(first[(level * Stride)..]);
            for (var i = 0; i < (count - 1 - level) * Stride; i++) points[i] = 0.5 * (points[i] + points[i + Stride]);
        }
    }

    private static bool IsHidden(Span<double> points, in Bounds2D clip)
    {
        var (left, right, above, below) = (true, true, true, true);
        for (var i = 0; i < points.Length; i += Stride)
        {
            var (x, y) = (points[i] / points[i + 2], points[i + 1] / points[i + 2]);
            left &= x < clip.MinX;
            right &= x > clip.MaxX;
            above &= y < clip.MinY;
            below &= y > clip.MaxY;
        }

        return left || right || above || below;
    }

    /// <summary>Are all inner control points within the tolerance of the chord as a segment (not as an infinite line)?</summary>
    private static bool IsFlat(Span<double> points)
    {
        var start = Control(points, 0);
        var chord = new LineSegment(start, Control(points, points.Length - Stride));
        for (var i = Stride; i < points.Length - Stride; i += Stride)
        {
            if (chord.DistanceTo(Control(points, i)) > ArcFlattener.FlatnessPixels) return false;
        }

        return true;
    }

    private static Point2D Control(Span<double> points, int at) => new(points[at] / points[at + 2], points[at + 1] / points[at + 2]);
}
