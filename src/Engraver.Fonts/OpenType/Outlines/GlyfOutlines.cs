namespace Engraver.Fonts.OpenType.Outlines;

/// <summary>TrueType outlines: tables glyf and loca.</summary>
internal sealed class GlyfOutlines : IGlyphOutlines
{
    private const int MaxNesting = 6;
    private const int MaxComponents = 1024;

    private readonly FontBytes _glyf;
    private readonly FontBytes _loca;
    private readonly bool _hasLongOffsets;
    private readonly int _count;

    public GlyfOutlines(FontFile file)
    {
        _glyf = file.Table("glyf");
        _loca = file.Table("loca");
        _hasLongOffsets = file.Table("head").Int16(50) != 0;
        _count = file.Table("maxp").UInt16(4);
    }

    public void Draw(int glyph, IOutlineSink sink)
    {
        if (glyph < 0 || glyph >= _count)
            return;
        var points = new GlyphPoints();
        var components = 0;
        Read(points, glyph, 0, ref components);
        points.Draw(sink);
    }

    public int? StatedLeft(int glyph)
    {
        const int OffsetOfLeft = 2;
        if (glyph < 0 || glyph >= _count)
            return null;
        var data = DataOf(glyph);
        return data.Length == 0 ? null : data.Int16(OffsetOfLeft);
    }

    /// <param name="components">Number of components that were read, so that a small file cannot ask for an endless glyph.</param>
    private void Read(GlyphPoints points, int glyph, int depth, ref int components)
    {
        if (glyph >= _count)
            throw new BrokenFontException("A glyph has a component that the font does not have.");
        var data = DataOf(glyph);
        if (data.Length == 0)
            return;
        var contours = data.Int16(0);
        if (contours >= 0)
            SimpleGlyph.Read(points, data, contours);
        else
            ReadComponents(points, data, depth, ref components);
    }

    private void ReadComponents(GlyphPoints points, FontBytes data, int depth, ref int components)
    {
        if (depth == MaxNesting)
            throw new BrokenFontException("The components of a glyph are nested too deeply.");
        var compound = points.Count;
        var offset = 10;
        GlyphComponent component;
        do
        {
            if (++components > MaxComponents)
                throw new BrokenFontException("A glyph has too many components.");
            component = GlyphComponent.Read(data, ref offset);
            var first = points.Count;
            Read(points, component.Glyph, depth + 1, ref components);
            component.Place(points, compound, first);
        }
        while (component.HasMore);
    }

    /// <summary>Empty for a blank glyph.</summary>
    private FontBytes DataOf(int glyph)
    {
        long start = Offset(glyph), end = Offset(glyph + 1);
        return end == start ? default : _glyf.Slice((int)start, (int)(end - start));
    }

    private long Offset(int glyph) => _hasLongOffsets ? _loca.UInt32(4 * glyph) : 2L * _loca.UInt16(2 * glyph);
}
