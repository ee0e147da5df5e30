using Avalonia.Media;
using Avalonia.Media.TextFormatting;
using Avalonia.Platform;

namespace Engraver.SoftwarePlatform.Text;

/// <summary>Text to glyphs: by <see cref="LineShaper"/> where one glyph for each character is enough, otherwise by HarfBuzz.</summary>
public sealed class SoftwareTextShaper : ITextShaperImpl
{
    public ITextShaperTypeface CreateTypeface(GlyphTypeface glyphTypeface) => new ShaperTypeface();

    public ShapedBuffer ShapeText(ReadOnlyMemory<char> text, TextShaperOptions options)
    {
        var isRightToLeft = (options.BidiLevel & 1) != 0;
        var glyphs = Shape(text, options, isRightToLeft);
        var buffer = new ShapedBuffer(text, glyphs.Count, options.GlyphTypeface, options.FontRenderingEmSize, options.BidiLevel);
        for (var i = 0; i < glyphs.Count; i++)
            buffer[i] = glyphs[isRightToLeft ? glyphs.Count - 1 - i : i];
        return buffer;
    }

    private static List<GlyphInfo> Shape(ReadOnlyMemory<char> text, in TextShaperOptions options, bool isRightToLeft)
    {
        var line = new LineShaper(options, text.Length);
        if (!isRightToLeft && ScriptRun.IsSimple(text.Span))
        {
            line.Shape(text.Span, 0, text.Length);
            return line.Glyphs;
        }
        var typeface = (SoftwareTypeface)options.GlyphTypeface.PlatformTypeface;
        foreach (var part in ScriptRun.Divide(text.Span, isRightToLeft))
        {
            if (part.IsComplex && typeface.HarfBuzz is { } harfBuzz)
                harfBuzz.Shape(text, part, options, line.Glyphs);
            else
                line.Shape(text.Span, part.Start, part.Length);
        }
        return line.Glyphs;
    }
}

/// <summary>An empty object, because Avalonia requires one; the shaper keeps what it needs in <see cref="SoftwareTypeface"/>.</summary>
internal sealed class ShaperTypeface : ITextShaperTypeface
{
    public void Dispose()
    {
    }
}
