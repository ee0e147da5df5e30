using System.Collections.Concurrent;

namespace Engraver.Fonts.StrokeFiles;

/// <summary>A text font of AutoCAD as compiled shapes (SHX: shapes 1.0, shapes 1.1, unifont 1.0; not bigfont). Lines and true arcs. A glyph is drawn when it
/// is asked for: <see cref="GlyphOf"/> throws a <see cref="BrokenFontException"/> if its codes are invalid.</summary>
public sealed class ShxFont : ITextFont
{
    /// <summary>Numbers of shapes below are control characters.</summary>
    private const int FirstCharacter = 0x20;
    private const int LineFeed = 10;
    private const int LastOfAscii = 0x7F;

    /// <summary>The line spacing of AutoCAD's text, in heights, if the font states none.</summary>
    private const double UsualLineSpacing = 5.0 / 3;

    private const int DegreeSign = 0xB0, PlusMinusSign = 0xB1, CrossedO = 0xD8;

    private readonly ShxFile _file;
    private readonly bool _isPacked;
    private readonly ConcurrentDictionary<int, GlyphCurves> _glyphs = new();

    private ShxFont(ShxFile file, string name)
    {
        _file = file;
        Name = file.Name.Length > 0 ? file.Name : name;
        var definition = new ShxBytes(file.Shape(0) ?? throw new BrokenFontException("The shape file is not a text font."));
        int above = definition.Next(), below = definition.Next();
        if (above == 0) throw new BrokenFontException("The SHX font has no height.");
        // Modes: whether the font has codes for vertical text.
        definition.Next();
        _isPacked = file.IsUnicode && definition.Next() != 0;
        Metrics = new FontMetrics(above + below, above, above, below, LineSpacingOf(file) ?? above * UsualLineSpacing);
    }

    public string Name { get; }

    public bool IsOutline => false;

    public FontMetrics Metrics { get; }

    /// <param name="name">If the font has none of its own.</param>
    /// <exception cref="BrokenFontException">Not a text font of one of the three kinds, or a broken one.</exception>
    public static ShxFont Read(ReadOnlyMemory<byte> data, string name) => new(ShxFile.Read(data), name);

    public bool Contains(int codePoint) => NumberOf(codePoint) is not null;

    public GlyphCurves? GlyphOf(int codePoint) => NumberOf(codePoint) is { } number ? _glyphs.GetOrAdd(number, Draw) : null;

    /// <returns>0: SHX fonts have no pairs.</returns>
    public double KerningOf(int left, int right) => 0;

    private GlyphCurves Draw(int number)
    {
        var (contours, end) = ShxShape.Draw(_file, number);
        return new GlyphCurves(end.X, contours);
    }

    /// <summary>The shape of a character. Fonts that are not Unicode have the signs of %%d, %%p and %%c after the letters, or degree and plus-minus where
    /// Latin-1 has them: then other signs are after the letters, and the crossed O is the diameter. Other characters are at the places of Latin-1.</summary>
    private int? NumberOf(int codePoint)
    {
        if (codePoint < FirstCharacter) return null;
        if (!_file.IsUnicode)
        {
            var hasLatin = Has(DegreeSign) && Has(PlusMinusSign);
            var sign = codePoint switch
            {
                DegreeSign when !hasLatin => 127,
                PlusMinusSign when !hasLatin => 128,
                DiameterSign.Code or DiameterSign.EmptySet => hasLatin && Has(CrossedO) ? CrossedO : 129,
                _ => 0,
            };
            if (sign > 0 && Has(sign)) return sign;
            return codePoint is < LastOfAscii or >= 0xA0 and <= 0xFF && Has(codePoint) ? codePoint : null;
        }

        if (_isPacked && codePoint > LastOfAscii) return null;
        return Has(codePoint) ? codePoint : DiameterSign.Other(codePoint) is var other && Has(other) ? other : null;
    }

    private bool Has(int number) => _file.Shape(number) is not null;

    /// <summary>How far the shape of a line feed moves down; null if the font has none.</summary>
    private static double? LineSpacingOf(ShxFile file) => file.Shape(LineFeed) is not null && ShxShape.Draw(file, LineFeed).End.Y is < 0 and var y ? -y : null;
}
