using Avalonia;
using Avalonia.Controls;
using Avalonia.Media;
using Engraver.App.Canvas.Colours;
using Engraver.App.Canvas.Flattening;
using Engraver.App.Canvas.Scenes;
using Engraver.App.Canvas.Views;
using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Workbench.Objects;

namespace Engraver.App.Canvas;

/// <summary>The visual between picture and cursor: hovered entity, the entity at the playback position, grips, positions of machine and playback, the
/// marked point, and the UCS icon.</summary>
internal sealed class CanvasMarkers : Control
{
    private const int MaxOutlinedParts = 2000;
    private const double GripSize = 3.5;
    private const double GripCell = 12.0;
    private const uint GripColour = 0xFF007FFF; // ACI 150..160: AutoCAD's unselected grip
    private const uint HoverGripColour = 0xFFFF7F7F; // ACI 11
    private const uint HotGripColour = 0xFFCC0000; // ACI 12

    private (CanvasScene? Scene, IReadOnlyList<int> Selection) _gripsKey = (null, []);

    public CanvasTheme Colours { get; set; } = CanvasTheme.Dark;

    public CanvasScene? Scene { get; set; }

    /// <summary>In pixels of the screen.</summary>
    public CanvasView View { get; set; }

    public double Scaling { get; set; } = 1.0;

    public int? Hovered { get; set; }

    public int? Highlight { get; set; }

    /// <summary>The grips that are shown.</summary>
    public IReadOnlyList<Grip> Grips { get; private set; } = [];

    /// <summary>Position of the grip under the cursor, drawing units; null for none.</summary>
    public Point2D? HoveredGrip { get; set; }

    /// <summary>Original position of the grip that is being dragged, drawing units; null while no grip is dragged.</summary>
    public Point2D? HotGrip { get; private set; }

    /// <summary>Position of the machine; null if unknown, or if no machine is connected.</summary>
    public MachineMark? Machine { get; set; }

    /// <summary>Position of the playback, drawing units; null while the playback is not shown.</summary>
    public Point2D? Playback { get; set; }

    public Point2D? PointedAt { get; set; }

    /// <summary>Shows the grips of a selection in the scene.</summary>
    public void ShowGrips(IReadOnlyList<int> selection, Point2D? hot)
    {
        HotGrip = hot;
        if (ReferenceEquals(Scene, _gripsKey.Scene) && ReferenceEquals(selection, _gripsKey.Selection)) return;
        _gripsKey = (Scene, selection);
        Grips = Scene is null ? [] : [.. ObjectGrips.Find(Scene.Drawing, selection)];
    }

    public override void Render(DrawingContext context)
    {
        if (View.Size.Width <= 0) return;
        DrawUcsIcon(context);
        if (Scene is { } scene)
        {
            if (Hovered is { } hovered) Outline(context, scene, hovered, CanvasBrushes.Pen(Colours.Hover, 2.5));
            if (Highlight is { } highlight) Outline(context, scene, highlight, CanvasBrushes.Pen(Colours.Playback, 3.0));
            DrawGrips(context);
        }

        if (PointedAt is { } place) DrawPointer(context, ToControl(place));
        if (Machine is { } machine) ToolMarks.DrawMachine(context, machine, ToControl, Bounds.Size, Colours);
        if (Playback is { } moment) ToolMarks.DrawPlayback(context, ToControl(moment), Colours);
    }

    private Point ToControl(Point2D place)
    {
        var pixel = View.ToPixels(place);
        return new Point(pixel.X / Scaling, pixel.Y / Scaling);
    }

    private void Outline(DrawingContext context, CanvasScene scene, int entity, IPen pen)
    {
        if ((uint)entity >= (uint)scene.Shown.Entities.Count || !DrawingPrimitives.IsVisible(scene.Shown, entity)) return;
        var geometry = new StreamGeometry();
        using (var sink = geometry.Open())
        {
            var outline = new OutlineSink(sink, Scaling);
            foreach (var segment in DrawingPick.Segments(scene.Shown, entity).Take(MaxOutlinedParts)) SegmentFlattener.Flatten(segment, View, ref outline);
        }

        context.DrawGeometry(null, pen, geometry);
    }

    /// <summary>At most one grip in a cell of the screen, so that a polyline of many short segments stays visible under its grips.</summary>
    private void DrawGrips(DrawingContext context)
    {
        var (window, taken) = (View.Window, new HashSet<(int, int)>());
        foreach (var place in Grips.Select(grip => grip.Place).OrderBy(place => place == HotGrip || place == HoveredGrip ? 0 : 1))
        {
            var at = ToControl(place);
            if (!window.Contains(place) || !taken.Add(((int)(at.X / GripCell), (int)(at.Y / GripCell)))) continue;
            var colour = place == HotGrip ? HotGripColour : place == HoveredGrip ? HoverGripColour : GripColour;
            context.DrawRectangle(CanvasBrushes.Brush(colour), null, new Rect(at.X - GripSize, at.Y - GripSize, 2.0 * GripSize, 2.0 * GripSize));
        }
    }

    /// <summary>At the origin if the icon fits there completely, otherwise in the lower left corner. X red, Y green.</summary>
    private void DrawUcsIcon(DrawingContext context)
    {
        const double Arm = 40.0;
        const double Corner = 14.0;
        var origin = ToControl(Point2D.Origin);
        var seen = new Rect(0.0, 0.0, Bounds.Width, Bounds.Height).Deflate(Corner);
        if (!seen.Contains(origin) || !seen.Contains(origin + new Point(Arm, -Arm))) origin = new Point(Corner, Bounds.Height - Corner);
        var (x, y) = (Math.Floor(origin.X) + 0.5, Math.Floor(origin.Y) + 0.5);
        var (red, green) = (CanvasBrushes.Pen(0xFFD0494F, 1.5), CanvasBrushes.Pen(0xFF4CB562, 1.5));
        context.DrawLine(red, new Point(x, y), new Point(x + Arm, y));
        context.DrawLine(green, new Point(x, y), new Point(x, y - Arm));
        context.DrawRectangle(null, CanvasBrushes.Pen(Colours.Rapid), new Rect(x - 4.0, y - 4.0, 8.0, 8.0));
        context.DrawLine(red, new Point(x + Arm + 4.0, y - 4.0), new Point(x + Arm + 10.0, y + 4.0));
        context.DrawLine(red, new Point(x + Arm + 4.0, y + 4.0), new Point(x + Arm + 10.0, y - 4.0));
        context.DrawLine(green, new Point(x - 4.0, y - Arm - 12.0), new Point(x, y - Arm - 7.0));
        context.DrawLine(green, new Point(x + 4.0, y - Arm - 12.0), new Point(x, y - Arm - 7.0));
        context.DrawLine(green, new Point(x, y - Arm - 7.0), new Point(x, y - Arm - 3.0));
    }

    private void DrawPointer(DrawingContext context, Point at)
    {
        var pen = CanvasBrushes.Pen(Colours.Finding, 2.0);
        context.DrawEllipse(null, pen, at, 16.0, 16.0);
        context.DrawEllipse(null, pen, at, 22.0, 22.0);
    }

    /// <summary>Collects chords as figures of a geometry, in units of the control.</summary>
    private struct OutlineSink(StreamGeometryContext context, double scaling) : IChordSink
    {
        private Point _end;
        private bool _hasFigure;

        public void Chord(double fromX, double fromY, double toX, double toY)
        {
            var (from, to) = (new Point(fromX / scaling, fromY / scaling), new Point(toX / scaling, toY / scaling));
            if (!_hasFigure || from != _end) context.BeginFigure(from, isFilled: false);
            context.LineTo(to);
            (_end, _hasFigure) = (to, true);
        }
    }
}

/// <summary>Pens and brushes from the colours of the canvas.</summary>
internal static class CanvasBrushes
{
    public static IBrush Brush(uint colour, double opacity = 1.0) => new Avalonia.Media.Immutable.ImmutableSolidColorBrush(Color.FromUInt32(colour), opacity);

    public static IPen DottedPen(uint colour) => new Pen(Brush(colour), 1.0, new DashStyle([1.0, 3.0], 0.0)).ToImmutable();

    public static IPen Pen(uint colour, double thickness = 1.0, bool dashed = false) =>
        new Pen(Brush(colour), thickness, dashed ? new DashStyle([4.0, 3.0], 0.0) : null).ToImmutable();
}
