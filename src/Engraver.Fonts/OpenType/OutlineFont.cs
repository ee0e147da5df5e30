using Engraver.Fonts.OpenType.Layout;
using Engraver.Fonts.OpenType.Outlines;

namespace Engraver.Fonts.OpenType;

/// <summary>One face of a TrueType or OpenType font, or of a collection of them. Curves are those of the font: quadratic in TrueType, cubic in CFF. Contours
/// may overlap. Every method may throw a <see cref="BrokenFontException"/>, because glyphs are read when they are asked for.</summary>
public sealed class OutlineFont : ITextFont
{
    private readonly FontFile _file;
    private readonly CharacterMap _characters;
    private readonly IGlyphOutlines _outlines;
    private readonly HorizontalMetrics _widths;
    private readonly PairKerning _pairs;
    private readonly KernTable _kern;
    private readonly int _glyphCount;

    /// <param name="face">Number of the face in a collection.</param>
    /// <exception cref="BrokenFontException">Not a font, no face of that number, or invalid tables.</exception>
    public OutlineFont(IFontSource source, int face = 0)
    {
        var file = _file = new FontFile(source, face);
        _glyphCount = file.Table("maxp").UInt16(4);
        _characters = CharacterMap.ReadBest(file.Table("cmap"));
        _outlines = GlyphOutlines.Read(file);
        _widths = new HorizontalMetrics(file);
        _pairs = PairKerning.Read(file);
        _kern = KernTable.Read(file);
        var names = FontNames.Read(file.Table("name"));
        Name = names.Full;
        FamilyName = names.Family;
        var style = FaceStyle.Read(file);
        (Weight, IsItalic) = (style.Weight, style.IsItalic);
        Metrics = MetricsOf(file);
    }

    public string Name { get; }

    public string FamilyName { get; }

    /// <summary>400 is regular, 700 is bold.</summary>
    public int Weight { get; }

    public bool IsItalic { get; }

    public bool IsOutline => true;

    public FontMetrics Metrics { get; }

    public bool Contains(int codePoint) => _characters.GlyphOf(codePoint) != 0;

    public GlyphCurves? GlyphOf(int codePoint)
    {
        var glyph = _characters.GlyphOf(codePoint);
        return glyph == 0 ? null : GlyphAt(glyph);
    }

    /// <summary>A glyph by its number: for texts that were shaped.</summary>
    public GlyphCurves GlyphAt(int glyph)
    {
        if (glyph < 0 || glyph >= _glyphCount)
            throw new BrokenFontException("A character of the font refers to a glyph that it does not have.");
        var contours = new ContourCollector(ShiftOf(glyph));
        _outlines.Draw(glyph, contours);
        return new GlyphCurves(_widths.AdvanceOf(glyph), contours.Contours);
    }

    /// <summary>The bytes of a table by its tag; null if the font has none.</summary>
    public ReadOnlyMemory<byte>? TableOf(uint tag) => _file.TryGetTable(tag, out var table) ? table : null;

    /// <summary>GPOS decides where the font has pairs in it, otherwise the older table kern.</summary>
    public double KerningOf(int left, int right)
    {
        int first = _characters.GlyphOf(left), second = _characters.GlyphOf(right);
        if (first == 0 || second == 0)
            return 0;
        return _pairs.IsEmpty ? _kern.Between(first, second) : _pairs.Between(first, second);
    }

    /// <summary>The outline of a TrueType glyph is where the table of widths has its left edge, which in some glyphs is not where the
    /// description has it.</summary>
    private int ShiftOf(int glyph) => _outlines.StatedLeft(glyph) is { } left ? _widths.LeftOf(glyph) - left : 0;

    private FontMetrics MetricsOf(FontFile file)
    {
        int unitsPerEm = file.Table("head").UInt16(18);
        if (unitsPerEm == 0)
            throw new BrokenFontException("The font has no size.");
        var (ascent, descent, gap) = VerticalMetrics(file);
        return new FontMetrics(unitsPerEm, CapHeightOf(file) ?? ascent, ascent, descent, ascent + descent + gap);
    }

    /// <summary>hhea, or OS/2 where the font prefers that or has no others.</summary>
    private static (int Ascent, int Descent, int Gap) VerticalMetrics(FontFile file)
    {
        const int PrefersTypographic = 1 << 7;
        var hhea = file.Table("hhea");
        var isEmpty = hhea.Int16(4) == 0 && hhea.Int16(6) == 0;
        if (!file.Has("OS/2"))
            return (hhea.Int16(4), -hhea.Int16(6), hhea.Int16(8));
        var os2 = file.Table("OS/2");
        return isEmpty || (os2.UInt16(62) & PrefersTypographic) != 0
            ? (os2.Int16(68), -os2.Int16(70), os2.Int16(72))
            : (hhea.Int16(4), -hhea.Int16(6), hhea.Int16(8));
    }

    /// <summary>As the font states it, otherwise the height of H; null for a font that has neither.</summary>
    private double? CapHeightOf(FontFile file)
    {
        const int OffsetOfCapHeight = 88;
        if (file.Has("OS/2") && file.Table("OS/2") is var os2 && os2.UInt16(0) >= 2 && os2.Int16(OffsetOfCapHeight) > 0)
            return os2.Int16(OffsetOfCapHeight);
        var ends = GlyphOf('H')?.Contours.SelectMany(contour => contour.Pieces).Select(piece => piece.End.Y).ToList();
        return ends is { Count: > 0 } && ends.Max() > 0 ? ends.Max() : null;
    }
}
