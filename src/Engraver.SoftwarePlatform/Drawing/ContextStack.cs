using Avalonia;
using Avalonia.Media;
using Engraver.SoftwarePlatform.Bitmaps;
using Engraver.SoftwarePlatform.Rasteriser;
using Engraver.SoftwarePlatform.Rasteriser.Paints;
using Engraver.SoftwarePlatform.Rasteriser.Paths;

namespace Engraver.SoftwarePlatform.Drawing;

/// <summary>The present transform, opacity and clip of a drawing context, and the stack of earlier ones.</summary>
internal sealed class ContextStack(SurfacePainter painter, DrawingScratch scratch, BrushPaints paints) : IDisposable
{
    private readonly Stack<DrawingState> _states = new();
    private readonly Stack<RenderOptions> _options = new();

    public Matrix Transform { get; set; } = Matrix.Identity;

    public double Opacity { get; private set; } = 1;

    public ClipShape Clip { get; private set; } = new(painter.Surface.Bounds);

    public SurfacePainter Painter { get; private set; } = painter;

    public DrawingScratch Scratch => scratch;

    public RenderOptions Options { get; private set; }

    /// <summary>Device pixels per unit, as a mean of both directions.</summary>
    public double Scale => Math.Sqrt(Math.Abs(Transform.GetDeterminant()));

    public bool IsAxisAligned => Math.Abs(Transform.M12) < 1e-9 && Math.Abs(Transform.M21) < 1e-9;

    private bool IsAliased => Options.EdgeMode == EdgeMode.Aliased;

    public void FillPath(VectorPath path, Paint paint) => ShapeFiller.FillPath(Painter, scratch, path, Transform, paint, Clip, IsAliased);

    public void FillRectangle(Rect rectangle, Paint paint)
    {
        if (IsAxisAligned)
        {
            var device = rectangle.TransformToAABB(Transform);
            ShapeFiller.FillRectangle(Painter, IsAliased ? Snapped(device) : device, paint, Clip);
            return;
        }
        var path = scratch.Path;
        path.Clear(FillRule.NonZero);
        path.AddRectangle(rectangle);
        FillPath(path, paint);
    }

    public void Push() => Push(null, null);

    public void PushClip(PixelBounds[] region)
    {
        Push();
        Clip = Clip.Within(region);
    }

    public void PushClip(Rect clip)
    {
        if (IsAxisAligned)
        {
            PushClip([PixelBounds.Snapped(clip.TransformToAABB(Transform))]);
            return;
        }
        PushClip(new RoundedRect(clip));
    }

    public void PushClip(RoundedRect clip)
    {
        if (!clip.IsRounded && IsAxisAligned)
        {
            PushClip(clip.Rect);
            return;
        }
        var path = scratch.Path;
        path.Clear(FillRule.NonZero);
        path.AddRoundedRectangle(clip);
        PushClip(path);
    }

    public void PushClip(VectorPath path)
    {
        var box = path.ControlBounds(Transform) is { } bounds ? PixelBounds.Around(bounds) : default;
        var visible = Clip.Visible(box);
        var mask = ShapeFiller.MaskOf(scratch, path, Transform, visible);
        if (Clip.Mask is { } outer)
            Multiply(mask, outer);
        Push(mask, null);
        Clip = Clip.WithMask(mask);
    }

    public void PushOpacity(double opacity, Rect? bounds)
    {
        if (Options.RequiresFullOpacityHandling == true && opacity < 1)
        {
            PushLayer(null, bounds, opacity);
            return;
        }
        Push();
        Opacity *= opacity;
    }

    public void PushOpacityMask(IBrush mask, Rect bounds) => PushLayer(mask, bounds, 1);

    public void PushOptions(RenderOptions options)
    {
        _options.Push(Options);
        Options = Options.MergeWith(options);
    }

    public void PopOptions() => Options = _options.Pop();

    public void Pop()
    {
        var state = _states.Pop();
        (Transform, Opacity, Clip) = (state.Transform, state.Opacity, state.Clip);
        state.OwnMask?.Dispose();
        if (state.Layer is { } layer)
            PutInPlace(layer);
    }

    /// <summary>Pops everything that was not popped, as after an exception while drawing.</summary>
    public void Dispose()
    {
        while (_states.TryPop(out var state))
        {
            state.OwnMask?.Dispose();
            state.Layer?.Bitmap.Dispose();
        }
    }

    private void Push(CoverageMask? ownMask, DrawingLayer? layer) => _states.Push(new DrawingState(Transform, Opacity, Clip, ownMask, layer));

    private void PushLayer(IBrush? mask, Rect? area, double opacity)
    {
        var box = area is { } known ? PixelBounds.Around(known.TransformToAABB(Transform)) : Clip.Bounds;
        var visible = Clip.Visible(box);
        var bitmap = new SoftwareBitmap(new PixelSize(visible.Width, visible.Height), new Vector(96, 96));
        Push(null, new DrawingLayer(bitmap, visible, Painter, mask, area ?? default, opacity));
        unsafe
        {
            var bounds = bitmap.Bounds.Offset(visible.Left, visible.Top);
            Painter = new SurfacePainter(new PixelSurface(bitmap.Pixels, bitmap.PixelSize.Width, bounds), scratch);
        }
        Clip = Clip.Within(visible).WithoutMask();
        Opacity = 1;
    }

    private void PutInPlace(DrawingLayer layer)
    {
        var drawn = Painter;
        Painter = layer.Beneath;
        if (!layer.Bounds.IsEmpty)
        {
            var opacity = layer.GroupOpacity * Opacity;
            if (layer.Mask is null || ApplyMask(layer, drawn))
                BitmapDrawing.PutLayer(this, layer.Bitmap, layer.Bounds, opacity);
        }
        layer.Bitmap.Dispose();
    }

    /// <returns>False when the mask lets nothing through.</returns>
    private bool ApplyMask(DrawingLayer layer, SurfacePainter drawn)
    {
        if (paints.Create(layer.Mask!, layer.MaskArea, 1, Transform, Options) is not { } paint)
            return false;
        var bounds = layer.Bounds;
        using var coverage = new CoverageMask(bounds);
        var shaded = new uint[bounds.Width];
        for (var y = bounds.Top; y < bounds.Bottom; y++)
        {
            paint.Shade(bounds.Left, y, shaded);
            var row = coverage.Row(y, bounds.Left, bounds.Right);
            for (var x = 0; x < shaded.Length; x++)
                row[x] = (byte)(shaded[x] >> 24);
            PixelRows.Scale(drawn.Surface.Row(y, bounds.Left, bounds.Right), row);
        }
        return true;
    }

    private static void Multiply(CoverageMask mask, CoverageMask outer)
    {
        var bounds = mask.Bounds;
        for (var y = bounds.Top; y < bounds.Bottom; y++)
            PixelRows.Multiply(mask.Row(y, bounds.Left, bounds.Right), outer.Row(y, bounds.Left, bounds.Right));
    }

    private static Rect Snapped(Rect device)
    {
        var pixels = PixelBounds.Snapped(device);
        return new Rect(pixels.Left, pixels.Top, Math.Max(0, pixels.Width), Math.Max(0, pixels.Height));
    }
}

/// <summary>A group that is drawn separately and then onto what is beneath, through a mask or with an opacity.</summary>
/// <param name="Bitmap">Holds the device pixels of <paramref name="Bounds"/>.</param>
/// <param name="Beneath">What was drawn on before.</param>
/// <param name="Mask">Brush whose alpha is used; null for a group with an opacity only.</param>
/// <param name="MaskArea">The brush's target, in the coordinates at the push.</param>
internal sealed record DrawingLayer(SoftwareBitmap Bitmap, PixelBounds Bounds, SurfacePainter Beneath, IBrush? Mask, Rect MaskArea, double GroupOpacity);

/// <summary>The state that a pop restores, and what it has to finish.</summary>
/// <param name="OwnMask">Mask made by the push; disposed at the pop.</param>
/// <param name="Layer">Group that the push began, to be put onto what was drawn on before.</param>
internal readonly record struct DrawingState(Matrix Transform, double Opacity, ClipShape Clip, CoverageMask? OwnMask, DrawingLayer? Layer);
