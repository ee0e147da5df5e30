using Engraver.SoftwarePlatform.Rasteriser;

namespace Engraver.SoftwarePlatform.Text;

internal sealed class CffOutlines(FontFile file) : IGlyphOutlines
{
    public VectorPath Outline(int glyph) => throw new BrokenFontException(file.ToString()!);
}
