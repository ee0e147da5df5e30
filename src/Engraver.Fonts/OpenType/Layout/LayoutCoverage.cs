namespace Engraver.Fonts.OpenType.Layout;

/// <summary>The two glyph lists of OpenType layout tables (OpenType 1.9, "Coverage table", "Class definition table").</summary>
public static class LayoutCoverage
{
    /// <summary>Number of the glyph in the list, or -1.</summary>
    public static int Index(FontBytes coverage, int glyph)
    {
        var isList = coverage.UInt16(0) == 1;
        int low = 0, high = coverage.UInt16(2) - 1;
        while (low <= high)
        {
            var middle = (low + high) / 2;
            var record = isList ? 4 + 2 * middle : 4 + 6 * middle;
            int first = coverage.UInt16(record), last = isList ? first : coverage.UInt16(record + 2);
            if (glyph < first)
                high = middle - 1;
            else if (glyph > last)
                low = middle + 1;
            else
                return isList ? middle : coverage.UInt16(record + 4) + glyph - first;
        }
        return -1;
    }

    /// <summary>Class of the glyph; 0 for all that are not listed.</summary>
    public static int Class(FontBytes classes, int glyph)
    {
        if (classes.UInt16(0) == 1)
        {
            int first = classes.UInt16(2), count = classes.UInt16(4);
            return glyph >= first && glyph < first + count ? classes.UInt16(6 + 2 * (glyph - first)) : 0;
        }
        int low = 0, high = classes.UInt16(2) - 1;
        while (low <= high)
        {
            var middle = (low + high) / 2;
            var record = 4 + 6 * middle;
            if (glyph < classes.UInt16(record))
                high = middle - 1;
            else if (glyph > classes.UInt16(record + 2))
                low = middle + 1;
            else
                return classes.UInt16(record + 4);
        }
        return 0;
    }
}
