using Engraver.App.Canvas.Scenes;
using Engraver.App.Canvas.Views;
using Engraver.Core.Geometry;

namespace Engraver.App.Canvas.Flattening;

/// <summary>One segment of the drawing as chords in pixels of a view, clipped well outside the picture.</summary>
internal static class SegmentFlattener
{
    private const double Margin = 16.0;

    public static void Flatten<TSink>(Segment segment, CanvasView view, ref TSink sink)
        where TSink : struct, IChordSink
    {
        var frame = PixelFrame.From(view);
        var clip = new Bounds2D(0.0, 0.0, view.Size.Width, view.Size.Height).Grown(Margin);
        if (segment.Kind == SegmentKind.Line) Line(segment.Line, frame, clip, ref sink);
        else if (segment.IsFreeCurve) CurveFlattener.Flatten(segment.Curve, frame, clip, ref sink);
        else ArcFlattener.Flatten(frame.X(segment.Arc.Centre.X), frame.Y(segment.Arc.Centre.Y), segment.Arc.Radius * frame.Scale, ArcSpan.From(segment.Arc), clip, ref sink);
    }

    /// <summary>A line is clipped, because some back ends cannot draw to an end a billion pixels away.</summary>
    private static void Line<TSink>(LineSegment line, in PixelFrame frame, in Bounds2D clip, ref TSink sink)
        where TSink : struct, IChordSink
    {
        var (from, to) = (new Point2D(frame.X(line.Start.X), frame.Y(line.Start.Y)), new Point2D(frame.X(line.End.X), frame.Y(line.End.Y)));
        var vector = to - from;
        var (first, last) = (0.0, 1.0);
        if (!ClipEdge(-vector.X, from.X - clip.MinX, ref first, ref last) || !ClipEdge(vector.X, clip.MaxX - from.X, ref first, ref last)) return;
        if (!ClipEdge(-vector.Y, from.Y - clip.MinY, ref first, ref last) || !ClipEdge(vector.Y, clip.MaxY - from.Y, ref first, ref last)) return;
        var (a, b) = (from + (vector * first), from + (vector * last));
        sink.Chord(a.X, a.Y, b.X, b.Y);
    }

    /// <summary>One border of the clipping by Liang and Barsky (1984): narrows the visible part of a line, first to last as fractions of the line. False if
    /// nothing remains.</summary>
    private static bool ClipEdge(double outward, double room, ref double first, ref double last)
    {
        if (outward == 0.0) return room >= 0.0;
        if (outward < 0.0) first = Math.Max(first, room / outward);
        else last = Math.Min(last, room / outward);
        return first <= last;
    }
}
