using Avalonia.Media;
using Avalonia.Media.TextFormatting;
using Avalonia.Platform;

namespace Engraver.SoftwarePlatform.Text;

/// <summary>Text to glyphs, one for each character: character map, advances and pair kerning. No ligatures, no joining scripts.</summary>
public sealed class SoftwareTextShaper : ITextShaperImpl
{
    public ITextShaperTypeface CreateTypeface(GlyphTypeface glyphTypeface) => new ShaperTypeface();

    public ShapedBuffer ShapeText(ReadOnlyMemory<char> text, TextShaperOptions options)
    {
        var line = new LineShaper(options);
        line.Shape(text.Span);
        var glyphs = line.Glyphs;
        var buffer = new ShapedBuffer(text, glyphs.Count, options.GlyphTypeface, options.FontRenderingEmSize, options.BidiLevel);
        var isRightToLeft = (options.BidiLevel & 1) != 0;
        for (var i = 0; i < glyphs.Count; i++)
            buffer[i] = glyphs[isRightToLeft ? glyphs.Count - 1 - i : i];
        return buffer;
    }
}

/// <summary>An empty object, because Avalonia requires one; the shaper keeps what it needs in <see cref="SoftwareTypeface"/>.</summary>
internal sealed class ShaperTypeface : ITextShaperTypeface
{
    public void Dispose()
    {
    }
}
