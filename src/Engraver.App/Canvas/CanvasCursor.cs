using System.Globalization;
using Avalonia;
using Avalonia.Controls;
using Avalonia.Media;
using Engraver.App.Canvas.Colours;
using Engraver.App.Canvas.Interaction;
using Engraver.App.Canvas.Picking;

namespace Engraver.App.Canvas;

/// <summary>The topmost visual: crosshair with pickbox, selection box, snap marker. Only this visual is redrawn when the mouse moves.</summary>
internal sealed class CanvasCursor : Control
{
    private const double MarkerSize = 6.0;
    private const double TipDistance = 18.0;
    private const double TipPadding = 5.0;
    private const double TipFontSize = 12.0;
    private const uint WindowColour = 0xFF3C82F0;
    private const uint CrossingColour = 0xFF46B450;
    private const uint SnapColour = 0xFF2EE06A;

    public CanvasTheme Colours { get; set; } = CanvasTheme.Dark;

    /// <summary>Position of the cursor; null outside the canvas.</summary>
    public Point? Place { get; set; }

    /// <summary>Length of the crosshair in percent of the canvas (CURSORSIZE).</summary>
    public double CursorSize { get; set; } = 5.0;

    /// <summary>Half the side of the pickbox.</summary>
    public double PickBox { get; set; } = 4.0;

    /// <summary>A plain cross without pickbox: a command asks for a point.</summary>
    public bool AsksForPoint { get; set; }

    public SelectionBox? Box { get; set; }

    /// <summary>From the previous point to the point that a click gives; null for no line.</summary>
    public (Point From, Point To)? Line { get; set; }

    /// <summary>The direction of polar tracking, from the previous point to beyond the canvas; null for none.</summary>
    public (Point From, Point To)? Track { get; set; }

    /// <summary>The result of a click, as polylines; empty for none.</summary>
    public IReadOnlyList<Point[]> Ghost { get; set; } = [];

    /// <summary>The text beside the crosshair; empty for none.</summary>
    public string Tip { get; set; } = "";

    public (Point Place, SnapKinds Kind)? Snap { get; set; }

    public override void Render(DrawingContext context)
    {
        DrawGhost(context);
        if (Box is { } box) DrawBox(context, box);
        if (Line is { } line) context.DrawLine(CanvasBrushes.Pen(Colours.Crosshair, dashed: true), line.From, line.To);
        if (Track is { } track) context.DrawLine(CanvasBrushes.DottedPen(SnapColour), track.From, track.To);
        if (Snap is { } snap) DrawSnap(context, snap.Place, snap.Kind);
        if (Place is not { } place) return;
        DrawCrosshair(context, place);
        if (Tip.Length > 0) DrawTip(context, place);
    }

    private void DrawGhost(DrawingContext context)
    {
        var pen = CanvasBrushes.Pen(Colours.Crosshair, dashed: true);
        foreach (var run in Ghost)
        {
            for (var i = 1; i < run.Length; i++) context.DrawLine(pen, run[i - 1], run[i]);
        }
    }

    /// <summary>Below and right of the cursor, or on the other side where there is not enough room.</summary>
    private void DrawTip(DrawingContext context, Point place)
    {
        var text = new FormattedText(Tip, CultureInfo.InvariantCulture, FlowDirection.LeftToRight, Typeface.Default, TipFontSize, CanvasBrushes.Brush(Colours.Crosshair));
        var size = new Size(text.Width + (2.0 * TipPadding), text.Height + (2.0 * TipPadding));
        var corner = new Point(
            place.X + TipDistance + size.Width <= Bounds.Width ? place.X + TipDistance : place.X - TipDistance - size.Width,
            place.Y + TipDistance + size.Height <= Bounds.Height ? place.Y + TipDistance : place.Y - TipDistance - size.Height);
        context.DrawRectangle(CanvasBrushes.Brush(Colours.Background, 0.9), CanvasBrushes.Pen(Colours.Rapid), new Rect(corner, size).Translate(new Vector(0.5, 0.5)), 3.0, 3.0);
        context.DrawText(text, corner + new Point(TipPadding, TipPadding));
    }

    private static void DrawBox(DrawingContext context, SelectionBox box)
    {
        var colour = box.IsCrossing ? CrossingColour : WindowColour;
        var area = new Rect(new Point(box.From.X, box.From.Y), new Point(box.To.X, box.To.Y)).Normalize();
        context.DrawRectangle(CanvasBrushes.Brush(colour, 0.22), CanvasBrushes.Pen(colour, dashed: box.IsCrossing), area);
    }

    private void DrawCrosshair(DrawingContext context, Point place)
    {
        var pen = CanvasBrushes.Pen(Colours.Crosshair);
        var arm = Math.Max(Bounds.Width, Bounds.Height) * CursorSize / 200.0;
        var gap = AsksForPoint ? 0.0 : PickBox;
        var (x, y) = (Math.Floor(place.X) + 0.5, Math.Floor(place.Y) + 0.5);
        context.DrawLine(pen, new Point(x - arm, y), new Point(x - gap, y));
        context.DrawLine(pen, new Point(x + gap, y), new Point(x + arm, y));
        context.DrawLine(pen, new Point(x, y - arm), new Point(x, y - gap));
        context.DrawLine(pen, new Point(x, y + gap), new Point(x, y + arm));
        if (!AsksForPoint) context.DrawRectangle(null, pen, new Rect(x - PickBox, y - PickBox, 2.0 * PickBox, 2.0 * PickBox));
    }

    /// <summary>Square, triangle, circle, diamond, right angle, hourglass, circle under a line, circle around a cross, cross: the markers of
    /// AutoCAD.</summary>
    private static void DrawSnap(DrawingContext context, Point at, SnapKinds kind)
    {
        var pen = CanvasBrushes.Pen(SnapColour, 2.0);
        const double Size = MarkerSize;
        if (kind == SnapKinds.Centre) context.DrawEllipse(null, pen, at, Size, Size);
        else if (kind == SnapKinds.End) DrawPolyline(context, pen, at, (-Size, -Size), (Size, -Size), (Size, Size), (-Size, Size));
        else if (kind == SnapKinds.Middle) DrawPolyline(context, pen, at, (0.0, -Size), (Size, Size * 0.8), (-Size, Size * 0.8));
        else if (kind == SnapKinds.Quadrant) DrawPolyline(context, pen, at, (0.0, -Size), (Size, 0.0), (0.0, Size), (-Size, 0.0));
        else if (kind == SnapKinds.Perpendicular) DrawPerpendicular(context, pen, at);
        else if (kind == SnapKinds.Nearest) DrawPolyline(context, pen, at, (-Size, -Size), (Size, -Size), (-Size, Size), (Size, Size));
        else if (kind == SnapKinds.Node) DrawNode(context, pen, at);
        else if (kind == SnapKinds.Tangent) DrawTangent(context, pen, at);
        else DrawCross(context, pen, at);
    }

    /// <summary>The marker of a perpendicular: a right angle.</summary>
    private static void DrawPerpendicular(DrawingContext context, IPen pen, Point at)
    {
        context.DrawLine(pen, at + new Point(-MarkerSize, -MarkerSize), at + new Point(-MarkerSize, MarkerSize));
        context.DrawLine(pen, at + new Point(-MarkerSize, MarkerSize), at + new Point(MarkerSize, MarkerSize));
        context.DrawLine(pen, at + new Point(-MarkerSize, 0.0), at);
        context.DrawLine(pen, at, at + new Point(0.0, MarkerSize));
    }

    /// <summary>The marker of a tangent: a circle under a line.</summary>
    private static void DrawTangent(DrawingContext context, IPen pen, Point at)
    {
        context.DrawEllipse(null, pen, at, MarkerSize, MarkerSize);
        context.DrawLine(pen, at + new Point(-MarkerSize, -MarkerSize), at + new Point(MarkerSize, -MarkerSize));
    }

    /// <summary>The marker of a node: a circle around a cross.</summary>
    private static void DrawNode(DrawingContext context, IPen pen, Point at)
    {
        context.DrawEllipse(null, pen, at, MarkerSize, MarkerSize);
        DrawCross(context, pen, at);
    }

    private static void DrawPolyline(DrawingContext context, IPen pen, Point at, params (double X, double Y)[] corners)
    {
        for (var i = 0; i < corners.Length; i++)
        {
            var (from, to) = (corners[i], corners[(i + 1) % corners.Length]);
            context.DrawLine(pen, at + new Point(from.X, from.Y), at + new Point(to.X, to.Y));
        }
    }

    private static void DrawCross(DrawingContext context, IPen pen, Point at)
    {
        context.DrawLine(pen, at + new Point(-MarkerSize, -MarkerSize), at + new Point(MarkerSize, MarkerSize));
        context.DrawLine(pen, at + new Point(-MarkerSize, MarkerSize), at + new Point(MarkerSize, -MarkerSize));
    }
}
