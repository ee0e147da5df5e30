using Avalonia;
using Avalonia.Media;
using Engraver.App.Canvas.Colours;
using Engraver.Core.Geometry;

namespace Engraver.App.Canvas;

/// <summary>The two positions of the tool: the machine, solid with a trail, and the playback, hollow. At the same position the second encloses the
/// first.</summary>
internal static class ToolMarks
{
    private const double Core = 5.5;
    private const double Ring = 10.0;
    private const double Reach = 16.0;

    /// <summary>The number of parts in which the trail is drawn, each fainter than the next.</summary>
    private const int TrailParts = 8;

    /// <summary>Outside the canvas, an arrow at its edge points to the machine.</summary>
    public static void DrawMachine(DrawingContext context, MachineMark mark, Func<Point2D, Point> toControl, Size canvas, CanvasTheme colours)
    {
        var colour = mark.IsCertain ? colours.Tool : colours.Rapid;
        DrawTrail(context, [.. mark.Trail.Select(place => toControl(mark.InDrawing(place)))], colour);
        var (at, seen) = (toControl(mark.Place), new Rect(canvas).Deflate(Core));
        if (!seen.Contains(at))
        {
            DrawArrow(context, seen, at, colour, colours);
            return;
        }

        var (halo, pen) = (CanvasBrushes.Pen(colours.Background, 4.0), CanvasBrushes.Pen(colour, 2.0));
        foreach (var stroke in new[] { halo, pen }) DrawCross(context, stroke, at, Core, Reach);
        context.DrawEllipse(CanvasBrushes.Brush(colour), CanvasBrushes.Pen(colours.Background, 1.5), at, Core + 1.0, Core + 1.0);
        if (!mark.IsCertain) DrawUncertain(context, at + new Point(Reach - 4.0, -Reach - 10.0), colour);
    }

    public static void DrawPlayback(DrawingContext context, Point at, CanvasTheme colours)
    {
        foreach (var pen in new[] { CanvasBrushes.Pen(colours.Background, 4.0), CanvasBrushes.Pen(colours.Playback, 2.0) })
        {
            context.DrawEllipse(null, pen, at, Ring, Ring);
            DrawCross(context, pen, at, Ring, Reach + 2.0);
        }
    }

    /// <summary>Four lines with a free middle.</summary>
    private static void DrawCross(DrawingContext context, IPen pen, Point at, double from, double to)
    {
        foreach (var way in new[] { new Point(1.0, 0.0), new Point(-1.0, 0.0), new Point(0.0, 1.0), new Point(0.0, -1.0) }) context.DrawLine(pen, at + (way * from), at + (way * to));
    }

    private static void DrawTrail(DrawingContext context, Point[] places, uint colour)
    {
        if (places.Length < 2) return;
        for (var part = 0; part < TrailParts; part++)
        {
            var (first, last) = (part * (places.Length - 1) / TrailParts, (part + 1) * (places.Length - 1) / TrailParts);
            if (first == last) continue;
            var pen = new Pen(CanvasBrushes.Brush(colour, 0.1 + (0.5 * (part + 1) / TrailParts)), 2.5).ToImmutable();
            context.DrawGeometry(null, pen, new PolylineGeometry(places[first..(last + 1)], isFilled: false));
        }
    }

    private static void DrawArrow(DrawingContext context, Rect seen, Point to, uint colour, CanvasTheme colours)
    {
        var way = to - seen.Center;
        var share = Math.Min(seen.Width / 2.0 / Math.Max(Math.Abs(way.X), 1e-9), seen.Height / 2.0 / Math.Max(Math.Abs(way.Y), 1e-9));
        var (tip, ahead) = (seen.Center + (way * share), new Point(way.X, way.Y) / Math.Max(Math.Sqrt((way.X * way.X) + (way.Y * way.Y)), 1e-9));
        var (back, side) = (tip - (ahead * 24.0), new Point(-ahead.Y, ahead.X) * 6.5);
        context.DrawGeometry(CanvasBrushes.Brush(colour), CanvasBrushes.Pen(colours.Background, 1.5), new PolylineGeometry([tip, back + side, back - side], isFilled: true));
    }

    private static void DrawUncertain(DrawingContext context, Point at, uint colour) =>
        context.DrawText(new FormattedText("?", System.Globalization.CultureInfo.InvariantCulture, FlowDirection.LeftToRight, Typeface.Default, 16.0, CanvasBrushes.Brush(colour)), at);
}
