using Avalonia;
using Avalonia.Media;
using Avalonia.Media.TextFormatting;
using Avalonia.Platform;
using Engraver.SoftwarePlatform.Rasteriser.Paths;

namespace Engraver.SoftwarePlatform.Text;

/// <summary>Glyphs at their positions along a baseline.</summary>
internal sealed class SoftwareGlyphRun : IGlyphRunImpl
{
    /// <summary>Part of the font size by which glyphs may extend beyond their advance.</summary>
    private const double Overhang = 0.25;

    private readonly ushort[] _glyphs;
    private readonly Vector[] _offsets;
    private VectorPath? _outline;

    public SoftwareGlyphRun(GlyphTypeface typeface, double size, IReadOnlyList<GlyphInfo> glyphs, Point baselineOrigin)
    {
        Typeface = (SoftwareTypeface)typeface.PlatformTypeface;
        FontRenderingEmSize = size;
        BaselineOrigin = baselineOrigin;
        _glyphs = new ushort[glyphs.Count];
        _offsets = new Vector[glyphs.Count];
        var x = 0.0;
        for (var i = 0; i < glyphs.Count; i++)
        {
            var glyph = glyphs[i];
            _glyphs[i] = glyph.GlyphIndex;
            _offsets[i] = glyph.GlyphOffset + new Vector(x, 0);
            x += glyph.GlyphAdvance;
        }
        var scale = size / Typeface.UnitsPerEm;
        double ascent = typeface.Metrics.Ascent * scale, descent = typeface.Metrics.Descent * scale;
        var room = Overhang * size;
        Bounds = new Rect(baselineOrigin.X - room, baselineOrigin.Y + ascent - room, x + 2 * room, descent - ascent + 2 * room);
    }

    public SoftwareTypeface Typeface { get; }

    public double FontRenderingEmSize { get; }

    public Point BaselineOrigin { get; }

    /// <summary>A box larger than the ink: from the font's highest to its lowest point, with an overhang on both sides.</summary>
    public Rect Bounds { get; }

    /// <summary>All glyphs as one path in the run's coordinates.</summary>
    public VectorPath Outline => _outline ??= MakeOutline();

    public ReadOnlySpan<ushort> Glyphs => _glyphs;

    /// <summary>From the baseline's origin to the origin of each glyph.</summary>
    public ReadOnlySpan<Vector> Offsets => _offsets;

    public IReadOnlyList<float> GetIntersections(float lowerLimit, float upperLimit) => [];

    public void Dispose()
    {
    }

    private VectorPath MakeOutline()
    {
        var path = new VectorPath(FillRule.NonZero);
        var transform = Typeface.GlyphTransform(FontRenderingEmSize);
        for (var i = 0; i < _glyphs.Length; i++)
            path.Append(Typeface.Outline(_glyphs[i]), transform * Matrix.CreateTranslation(BaselineOrigin.X + _offsets[i].X, BaselineOrigin.Y + _offsets[i].Y));
        return path;
    }
}
