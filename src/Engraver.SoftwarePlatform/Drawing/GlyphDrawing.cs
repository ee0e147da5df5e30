using Engraver.SoftwarePlatform.Rasteriser;
using Engraver.SoftwarePlatform.Rasteriser.Paints;
using Engraver.SoftwarePlatform.Text;

namespace Engraver.SoftwarePlatform.Drawing;

/// <summary>Draws glyphs from cached masks, at whole pixels vertically and quarters of a pixel horizontally; large or rotated ones as outlines.</summary>
internal static class GlyphDrawing
{
    private const double LargestMaskedSize = 96;

    public static void Draw(ContextStack state, SoftwareGlyphRun run, Paint paint)
    {
        var transform = state.Transform;
        var isUpright = state.IsAxisAligned && transform.M11 > 0 && Math.Abs(transform.M11 - transform.M22) < 1e-6;
        if (!isUpright || run.FontRenderingEmSize * transform.M11 > LargestMaskedSize)
        {
            state.FillPath(run.Outline, paint);
            return;
        }
        if (state.Clip.IsEmpty)
            return;
        var scale = transform.M11;
        var size = GlyphSize.ToParts(run.FontRenderingEmSize * scale);
        var tone = paint is SolidPaint solid ? TextTone.From(solid.Color) : TextTone.Middle;
        var masks = run.Typeface.Masks.Of(size, tone);
        var baseX = run.BaselineOrigin.X * scale + transform.M31;
        var baseY = PixelBounds.Nearest(run.BaselineOrigin.Y * scale + transform.M32);
        var glyphs = run.Glyphs;
        var offsets = run.Offsets;
        for (var i = 0; i < glyphs.Length; i++)
        {
            var quarters = (int)Math.Floor((baseX + offsets[i].X * scale) * GlyphSize.StepsPerPixel + 0.5);
            var (x, step) = (quarters >> GlyphSize.StepBits, quarters & (GlyphSize.StepsPerPixel - 1));
            var y = offsets[i].Y == 0 ? baseY : baseY + PixelBounds.Nearest(offsets[i].Y * scale);
            Draw(state, masks.Get(glyphs[i], step), x, y, paint);
        }
    }

    private static void Draw(ContextStack state, GlyphMask mask, int x, int y, Paint paint)
    {
        var place = mask.Bounds.Offset(x, y);
        var clip = state.Clip;
        if (!clip.Touches(place))
            return;
        if (paint is SolidPaint solid && clip.ShowsAll(place) && place.Left + mask.Stride <= state.Painter.Surface.Bounds.Right)
        {
            PixelRows.BlendColor(state.Painter.Surface, place.Left, place.Top, solid.Color, mask.Cells, mask.Stride);
            return;
        }
        var bottom = Math.Min(place.Bottom, clip.Bounds.Bottom);
        for (var row = Math.Max(place.Top, clip.Bounds.Top); row < bottom; row++)
            state.Painter.Cells(row, place.Left, mask.Row(row - y), paint, clip);
    }
}
