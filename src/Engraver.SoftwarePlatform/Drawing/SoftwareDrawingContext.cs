using Avalonia;
using Avalonia.Media;
using Avalonia.Platform;
using Engraver.SoftwarePlatform.Bitmaps;
using Engraver.SoftwarePlatform.Geometry;
using Engraver.SoftwarePlatform.Rasteriser;
using Engraver.SoftwarePlatform.Rasteriser.Paints;
using Engraver.SoftwarePlatform.Rasteriser.Paths;
using Engraver.SoftwarePlatform.Text;

namespace Engraver.SoftwarePlatform.Drawing;

/// <summary>Draws on one surface. Every pop restores the transform, opacity and clip before its push.</summary>
internal sealed class SoftwareDrawingContext : IDrawingContextImpl
{
    private readonly DrawingScratch _scratch = DrawingScratch.Take();
    private readonly ContextStack _state;
    private readonly BrushPaints _paints;
    private readonly Vector _dpi;
    private readonly Action? _finished;
    private bool _isDisposed;

    /// <param name="finished">Called once when drawing ends.</param>
    public SoftwareDrawingContext(PixelSurface surface, Vector dpi, Action? finished)
    {
        _dpi = dpi;
        _finished = finished;
        _paints = new BrushPaints();
        _state = new ContextStack(new SurfacePainter(surface, _scratch), _scratch, _paints);
    }

    public Matrix Transform
    {
        get => _state.Transform;
        set => _state.Transform = value;
    }

    public void Clear(Color color) => ShapeFiller.Clear(_state.Painter, PixelArithmetic.Premultiplied(color, 1), _state.Clip);

    public void DrawBitmap(IBitmapImpl source, double opacity, Rect sourceRect, Rect destRect) =>
        BitmapDrawing.Draw(_state, (SoftwareBitmap)source, opacity * _state.Opacity, sourceRect, destRect);

    public void DrawBitmap(IBitmapImpl source, IBrush opacityMask, Rect opacityMaskRect, Rect destRect)
    {
        PushOpacityMask(opacityMask, opacityMaskRect);
        DrawBitmap(source, 1, new Rect(source.PixelSize.ToSize(1)), destRect);
        PopOpacityMask();
    }

    public void DrawLine(IPen? pen, Point p1, Point p2)
    {
        var path = _scratch.Path;
        path.Clear(FillRule.NonZero);
        path.MoveTo(p1);
        path.LineTo(p2);
        Stroke(path, pen, new Rect(p1, p2).Normalize());
    }

    public void DrawGeometry(IBrush? brush, IPen? pen, IGeometryImpl geometry)
    {
        var shape = (SoftwareGeometry)geometry;
        Fill(shape.FillPath, brush, shape.Bounds);
        Stroke(shape.StrokePath, pen, shape.Bounds);
    }

    public void DrawRectangle(IBrush? brush, IPen? pen, RoundedRect rect, BoxShadows boxShadows = default)
    {
        if (rect.Rect.Width <= 0 || rect.Rect.Height <= 0)
            return;
        var fill = PaintOf(brush, rect.Rect);
        ShadowPainting.DrawOuter(_state, rect, boxShadows, fill?.IsOpaque == true);
        if (fill is not null)
            FillRounded(rect, fill);
        ShadowPainting.DrawInset(_state, rect, boxShadows);
        if (pen?.Brush is not null && pen.Thickness > 0)
            DrawBorder(pen, rect);
    }

    public void DrawRegion(IBrush? brush, IPen? pen, IPlatformRenderInterfaceRegion region)
    {
        foreach (var part in region.Rects)
            DrawRectangle(brush, pen, new RoundedRect(new Rect(new Point(part.Left, part.Top), new Point(part.Right, part.Bottom))));
    }

    public void DrawEllipse(IBrush? brush, IPen? pen, Rect rect)
    {
        var path = _scratch.Path;
        path.Clear(FillRule.NonZero);
        path.AddEllipse(rect);
        Fill(path, brush, rect);
        Stroke(path, pen, rect);
    }

    public void DrawGlyphRun(IBrush? foreground, IGlyphRunImpl glyphRun)
    {
        var run = (SoftwareGlyphRun)glyphRun;
        if (PaintOf(foreground, run.Bounds) is { } paint)
            GlyphDrawing.Draw(_state, run, paint);
    }

    public IDrawingContextLayerImpl CreateLayer(PixelSize size) => new DrawableBitmap(size, _dpi);

    public void PushClip(Rect clip) => _state.PushClip(clip);

    public void PushClip(RoundedRect clip) => _state.PushClip(clip);

    public void PushClip(IPlatformRenderInterfaceRegion region) => _state.PushClip(((SoftwareRegion)region).ToBounds());

    public void PopClip() => _state.Pop();

    public void PushGeometryClip(IGeometryImpl clip) => _state.PushClip(((SoftwareGeometry)clip).FillPath);

    public void PopGeometryClip() => _state.Pop();

    public void PushLayer(Rect bounds) => _state.Push();

    public void PopLayer() => _state.Pop();

    public void PushOpacity(double opacity, Rect? bounds) => _state.PushOpacity(opacity, bounds);

    public void PopOpacity() => _state.Pop();

    public void PushOpacityMask(IBrush mask, Rect bounds) => _state.PushOpacityMask(mask, bounds);

    public void PopOpacityMask() => _state.Pop();

    public void PushRenderOptions(RenderOptions renderOptions) => _state.PushOptions(renderOptions);

    public void PopRenderOptions() => _state.PopOptions();

    /// <summary>Ignored: text is always drawn the same way.</summary>
    public void PushTextOptions(TextOptions textOptions)
    {
    }

    public void PopTextOptions()
    {
    }

    public object? GetFeature(Type t) => null;

    public void Dispose()
    {
        if (_isDisposed)
            return;
        _isDisposed = true;
        _state.Dispose();
        _paints.Dispose();
        _scratch.GiveBack();
        _finished?.Invoke();
    }

    /// <summary>Copies a layer's pixels to the top left of the surface, without blending.</summary>
    internal void CopyFrom(SoftwareBitmap layer)
    {
        var target = _state.Painter.Surface;
        var common = target.Bounds.Intersect(layer.Bounds);
        for (var y = common.Top; y < common.Bottom; y++)
            layer.Row(y)[common.Left..common.Right].CopyTo(target.Row(y, common.Left, common.Right));
    }

    private Paint? PaintOf(IBrush? brush, Rect area) => brush is null ? null : _paints.Create(brush, area, _state.Opacity, _state.Transform, _state.Options);

    private void Fill(VectorPath path, IBrush? brush, Rect area)
    {
        if (PaintOf(brush, area) is { } paint)
            _state.FillPath(path, paint);
    }

    private void FillRounded(RoundedRect rect, Paint paint)
    {
        if (!rect.IsRounded)
        {
            _state.FillRectangle(rect.Rect, paint);
            return;
        }
        var path = _scratch.Path;
        path.Clear(FillRule.NonZero);
        path.AddRoundedRectangle(rect);
        _state.FillPath(path, paint);
    }

    private void Stroke(VectorPath path, IPen? pen, Rect area)
    {
        if (pen?.Brush is null || pen.Thickness <= 0)
            return;
        if (PaintOf(pen.Brush, area.Inflate(pen.Thickness / 2)) is { } paint)
            _state.FillPath(Stroker.Stroke(path, StrokeStyle.From(pen), _state.Scale), paint);
    }

    /// <summary>A solid border is the area between two rounded rectangles.</summary>
    private void DrawBorder(IPen pen, RoundedRect rect)
    {
        var path = _scratch.Path;
        if (pen.DashStyle?.Dashes is { Count: > 0 })
        {
            path.Clear(FillRule.NonZero);
            path.AddRoundedRectangle(rect);
            Stroke(path, pen, rect.Rect);
            return;
        }
        if (PaintOf(pen.Brush, rect.Rect.Inflate(pen.Thickness / 2)) is not { } paint)
            return;
        var half = pen.Thickness / 2;
        path.Clear(FillRule.EvenOdd);
        path.AddRoundedRectangle(rect.Grown(half));
        if (rect.Rect.Width > pen.Thickness && rect.Rect.Height > pen.Thickness)
            path.AddRoundedRectangle(rect.Grown(-half));
        _state.FillPath(path, paint);
    }
}
