using Engraver.Fonts.OpenType;
using Engraver.TestKit;

namespace Engraver.Fonts.Tests;

internal static class WrittenFont
{
    public static OutlineFont Read(this FontBuilder font) => new(new MemoryFontSource(font.Build()));
}
