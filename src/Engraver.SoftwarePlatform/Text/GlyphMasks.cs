using System.Collections.Concurrent;
using Avalonia;
using Engraver.SoftwarePlatform.Rasteriser;

namespace Engraver.SoftwarePlatform.Text;

/// <summary>Caches the masks of one typeface. Drops all when they become too many.</summary>
internal sealed class GlyphMasks(SoftwareTypeface typeface)
{
    private const int MaxBytes = 8 << 20;

    private readonly ConcurrentDictionary<(ushort Glyph, int Size, int Step, TextTone Tone), GlyphMask?> _masks = new();
    private int _bytes;

    /// <param name="size">Result of <see cref="GlyphSize.ToParts"/>.</param>
    /// <param name="step">Quarters of a pixel to the right.</param>
    /// <returns>Null for a glyph without ink.</returns>
    public GlyphMask? Get(ushort glyph, int size, int step, TextTone tone)
    {
        var key = (glyph, size, step, tone);
        if (_masks.TryGetValue(key, out var known))
            return known;
        var mask = Make(glyph, size, step, tone);
        if (Interlocked.Add(ref _bytes, 64 + (mask?.Bytes ?? 0)) > MaxBytes)
        {
            _masks.Clear();
            Interlocked.Exchange(ref _bytes, 0);
        }
        _masks.TryAdd(key, mask);
        return mask;
    }

    private GlyphMask? Make(ushort glyph, int size, int step, TextTone tone)
    {
        var transform = typeface.GlyphTransform(GlyphSize.PixelsPerEm(size)) * Matrix.CreateTranslation((double)step / GlyphSize.StepsPerPixel, 0);
        var outline = typeface.Outline(glyph);
        if (outline.ControlBounds(transform) is not { } box || box.Width <= 0 || box.Height <= 0)
            return null;
        var bounds = PixelBounds.Around(box);
        var scratch = DrawingScratch.Take();
        using var mask = ShapeFiller.MaskOf(scratch, outline, transform, bounds);
        scratch.GiveBack();
        var cells = mask.Cells.ToArray();
        tone.Apply(cells);
        return new GlyphMask(bounds, cells);
    }
}
