using Avalonia;
using Avalonia.Media;
using Engraver.SoftwarePlatform.Rasteriser;
using Engraver.SoftwarePlatform.Rasteriser.Paints;
using Engraver.SoftwarePlatform.Rasteriser.Paths;
using Engraver.SoftwarePlatform.Rasteriser.Shadows;

namespace Engraver.SoftwarePlatform.Drawing;

/// <summary>Box shadows, outside and inside of a rounded rectangle.</summary>
internal static class ShadowPainting
{
    /// <param name="boxIsOpaque">The box will hide what is under it; otherwise the shadow is not drawn there.</param>
    public static void DrawOuter(ContextStack state, RoundedRect box, BoxShadows shadows, bool boxIsOpaque)
    {
        for (var i = 0; i < shadows.Count; i++)
        {
            if (!shadows[i].IsInset && shadows[i].Color.A > 0)
                DrawOuter(state, box, shadows[i], boxIsOpaque);
        }
    }

    public static void DrawInset(ContextStack state, RoundedRect box, BoxShadows shadows)
    {
        for (var i = 0; i < shadows.Count; i++)
        {
            if (shadows[i].IsInset && shadows[i].Color.A > 0)
                DrawInset(state, box, shadows[i]);
        }
    }

    private static void DrawOuter(ContextStack state, RoundedRect box, BoxShadow shadow, bool boxIsOpaque)
    {
        var paint = new SolidPaint(PixelArithmetic.Premultiplied(shadow.Color, state.Opacity));
        var grown = box.Grown(shadow.Spread);
        var transform = Matrix.CreateTranslation(shadow.OffsetX, shadow.OffsetY) * state.Transform;
        var blur = ShadowBlur.FromRadius(shadow.Blur * state.Scale);
        if (Bounds(PathOf(grown), transform) is not { } bounds || !state.Clip.Touches(bounds.Inflate(blur.Reach)))
            return;
        if (!state.IsAxisAligned || blur.IsNone)
        {
            using var exact = ShapeFiller.MaskOf(state.Scratch, PathOf(grown), transform, bounds.Inflate(blur.Reach));
            blur.Apply(exact);
            PaintAround(state, box, exact, paint, boxIsOpaque);
            return;
        }
        var stretched = Soft(state, grown, transform, blur);
        if (boxIsOpaque)
        {
            stretched.Paint(state, paint);
            return;
        }
        using var whole = stretched.ToMask();
        PaintAround(state, box, whole, paint, boxIsOpaque);
    }

    /// <summary>A soft shadow is drawn at whole pixels: the difference is not visible, and its mask can be cached.</summary>
    private static StretchedShadow Soft(ContextStack state, RoundedRect grown, in Matrix transform, ShadowBlur blur)
    {
        double scaleX = Math.Abs(transform.M11), scaleY = Math.Abs(transform.M22);
        Vector Scaled(Vector radius) => new(radius.X * scaleX, radius.Y * scaleY);
        var device = new RoundedRect(
            grown.Rect.TransformToAABB(transform),
            Scaled(grown.RadiiTopLeft),
            Scaled(grown.RadiiTopRight),
            Scaled(grown.RadiiBottomRight),
            Scaled(grown.RadiiBottomLeft));
        var pixels = PixelBounds.Snapped(device.Rect);
        var mask = state.Scratch.Shadows.Get(ShadowShape.Smallest(device, pixels, blur), state.Scratch);
        return new StretchedShadow(mask, pixels.Inflate(blur.Reach));
    }

    private static void PaintAround(ContextStack state, RoundedRect box, CoverageMask mask, Paint paint, bool boxIsOpaque)
    {
        if (!boxIsOpaque)
            CutOut(state, mask, PathOf(box));
        Paint(state, mask, paint);
    }

    /// <summary>The shadow of everything outside a smaller box, visible inside the box.</summary>
    private static void DrawInset(ContextStack state, RoundedRect box, BoxShadow shadow)
    {
        var paint = new SolidPaint(PixelArithmetic.Premultiplied(shadow.Color, state.Opacity));
        var hole = PathOf(box.Grown(-shadow.Spread));
        var transform = Matrix.CreateTranslation(shadow.OffsetX, shadow.OffsetY) * state.Transform;
        var blur = ShadowBlur.FromRadius(shadow.Blur * state.Scale);
        if (Bounds(PathOf(box), state.Transform) is not { } bounds || !state.Clip.Touches(bounds))
            return;
        using var mask = ShapeFiller.MaskOf(state.Scratch, hole, transform, bounds.Inflate(blur.Reach));
        Invert(mask);
        blur.Apply(mask);
        using var inside = ShapeFiller.MaskOf(state.Scratch, PathOf(box), state.Transform, mask.Bounds);
        PixelRows.Multiply(mask.Cells, inside.Cells);
        Paint(state, mask, paint);
    }

    private static void CutOut(ContextStack state, CoverageMask mask, VectorPath path)
    {
        using var hole = ShapeFiller.MaskOf(state.Scratch, path, state.Transform, mask.Bounds);
        Invert(hole);
        PixelRows.Multiply(mask.Cells, hole.Cells);
    }

    private static void Invert(CoverageMask mask)
    {
        foreach (ref var cell in mask.Cells)
            cell = (byte)(255 - cell);
    }

    private static void Paint(ContextStack state, CoverageMask mask, Paint paint)
    {
        var visible = state.Clip.Visible(mask.Bounds);
        for (var y = visible.Top; y < visible.Bottom; y++)
            state.Painter.Cells(y, visible.Left, mask.Row(y, visible.Left, visible.Right), paint, state.Clip);
    }

    private static PixelBounds? Bounds(VectorPath path, in Matrix transform) =>
        path.ControlBounds(transform) is { } box ? PixelBounds.Around(box) : null;

    private static VectorPath PathOf(RoundedRect box)
    {
        var path = new VectorPath(FillRule.NonZero);
        path.AddRoundedRectangle(box);
        return path;
    }
}
