using Avalonia;
using Avalonia.Media;
using Engraver.SoftwarePlatform.Rasteriser.Paths;

namespace Engraver.SoftwarePlatform.Text.Outlines;

/// <summary>TrueType outlines: tables glyf and loca.</summary>
internal sealed class GlyfOutlines : IGlyphOutlines
{
    private const int MaxNesting = 6;

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

    public VectorPath Outline(int glyph)
    {
        var path = new VectorPath(FillRule.NonZero);
        Add(path, glyph, Matrix.Identity, 0);
        return path;
    }

    private void Add(VectorPath path, int glyph, in Matrix transform, int depth)
    {
        if (glyph < 0 || glyph >= _count || depth > MaxNesting)
            return;
        var start = Offset(glyph);
        var end = Offset(glyph + 1);
        if (end <= start)
            return;
        var data = _glyf.Slice((int)start, (int)(end - start));
        var contours = data.Int16(0);
        if (contours >= 0)
            SimpleGlyph.Add(path, data, contours, transform);
        else
            AddComponents(path, data, transform, depth);
    }

    private void AddComponents(VectorPath path, FontBytes data, in Matrix transform, int depth)
    {
        var offset = 10;
        GlyphComponent component;
        do
        {
            component = GlyphComponent.Read(data, ref offset);
            Add(path, component.Glyph, component.Transform * transform, depth + 1);
        }
        while (component.HasMore);
    }

    private long Offset(int glyph) => _hasLongOffsets ? _loca.UInt32(4 * glyph) : 2L * _loca.UInt16(2 * glyph);
}
