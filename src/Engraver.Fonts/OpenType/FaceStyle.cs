namespace Engraver.Fonts.OpenType;

/// <summary>Weight, width and slant of a face (OpenType 1.9, OS/2 and head).</summary>
/// <param name="Weight">400 is regular, 700 is bold.</param>
/// <param name="Width">5 is normal, smaller is condensed.</param>
public readonly record struct FaceStyle(int Weight, int Width, bool IsItalic)
{
    private const int Regular = 400, Bold = 700, NormalWidth = 5;

    /// <summary>From here a weight counts as bold.</summary>
    private const int SemiBold = 600;

    public bool IsBold => Weight >= SemiBold;

    /// <exception cref="BrokenFontException">The tables are invalid.</exception>
    public static FaceStyle Read(FontFile file)
    {
        const int BoldInHead = 1, ItalicInHead = 2;
        if (file.Has("OS/2"))
        {
            var style = file.Table("OS/2");
            return new FaceStyle(style.UInt16(4), style.UInt16(6), (style.UInt16(62) & 1) != 0);
        }
        var flags = file.Table("head").UInt16(44);
        return new FaceStyle((flags & BoldInHead) != 0 ? Bold : Regular, NormalWidth, (flags & ItalicInHead) != 0);
    }

    /// <summary>How far this style is from a requested one: slant first, then weight, then width.</summary>
    public int DistanceTo(bool isBold, bool isItalic) =>
        (IsItalic == isItalic ? 0 : 100_000) + (20 * Math.Abs(Weight - (isBold ? Bold : Regular))) + Math.Abs(Width - NormalWidth);
}
