using Avalonia;
using Engraver.SoftwarePlatform.Rasteriser;

namespace Engraver.SoftwarePlatform.Text;

/// <summary>The masks of one typeface in one size and tone, found by index without hashing. Threads may draw at once: a mask is complete before it is stored,
/// and of two that are made at the same time either one is kept.</summary>
/// <param name="grew">Receives the number of bytes of each new part.</param>
internal sealed class SizedGlyphMasks(SoftwareTypeface typeface, int size, TextTone tone, Action<int> grew)
{
    private const int GlyphsOfPage = 64;
    private const int ObjectBytes = 64;

    private readonly GlyphMask?[]?[] _pages = new GlyphMask?[(ushort.MaxValue + 1) / GlyphsOfPage][];

    /// <param name="step">Quarters of a pixel to the right.</param>
    public GlyphMask Get(ushort glyph, int step)
    {
        var page = Volatile.Read(ref _pages[glyph / GlyphsOfPage]) ?? AddPage(glyph / GlyphsOfPage);
        ref var place = ref page[glyph % GlyphsOfPage * GlyphSize.StepsPerPixel + step];
        return Volatile.Read(ref place) ?? Add(ref place, glyph, step);
    }

    private GlyphMask?[] AddPage(int index)
    {
        var page = new GlyphMask?[GlyphsOfPage * GlyphSize.StepsPerPixel];
        grew(ObjectBytes + page.Length * IntPtr.Size);
        return Interlocked.CompareExchange(ref _pages[index], page, null) ?? page;
    }

    private GlyphMask Add(ref GlyphMask? place, ushort glyph, int step)
    {
        var mask = Make(glyph, step);
        grew(ObjectBytes + mask.Cells.Length);
        Volatile.Write(ref place, mask);
        return mask;
    }

    private GlyphMask Make(ushort glyph, int step)
    {
        var transform = typeface.GlyphTransform(GlyphSize.PixelsPerEm(size)) * Matrix.CreateTranslation((double)step / GlyphSize.StepsPerPixel, 0);
        var outline = typeface.Outline(glyph);
        if (outline.ControlBounds(transform) is not { } box || box.Width <= 0 || box.Height <= 0)
            return GlyphMask.Blank;
        var bounds = PixelBounds.Around(box);
        var scratch = DrawingScratch.Take();
        using var mask = ShapeFiller.MaskOf(scratch, outline, transform, bounds);
        scratch.GiveBack();
        tone.Apply(mask.Cells);
        return new GlyphMask(bounds, mask.Cells);
    }
}
