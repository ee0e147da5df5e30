namespace Engraver.Fonts.OpenType.Outlines;

/// <summary>Selects the part of a large font that describes a glyph (Adobe TN 5176, section 19).</summary>
internal sealed class CffFontSelection(FontBytes data)
{
    public int FontOf(int glyph)
    {
        switch (data.Byte(0))
        {
            case 0:
                return data.Byte(1 + glyph);
            case 3:
                return InRanges(glyph);
            default:
                throw new BrokenFontException("The font's list of parts has an unknown format.");
        }
    }

    /// <summary>Ranges are in order; each begins with its first glyph and ends where the next begins.</summary>
    private int InRanges(int glyph)
    {
        int low = 0, high = data.UInt16(1) - 1;
        while (low < high)
        {
            var middle = (low + high + 1) / 2;
            if (data.UInt16(3 + 3 * middle) <= glyph)
                low = middle;
            else
                high = middle - 1;
        }
        return data.Byte(3 + 3 * low + 2);
    }
}
