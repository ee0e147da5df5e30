using Avalonia.Media;
using Avalonia.Media.TextFormatting;
using Avalonia.Media.TextFormatting.Unicode;

namespace Engraver.SoftwarePlatform.Text;

/// <summary>Shapes one piece of text of one font; glyphs stand in the order of the text.</summary>
internal sealed class LineShaper(TextShaperOptions options)
{
    private const int SpacesOfTab = 4;

    private readonly GlyphTypeface _typeface = options.GlyphTypeface;
    private readonly PairKerning? _kerning = (options.GlyphTypeface.PlatformTypeface as SoftwareTypeface)?.Kerning;
    private readonly double _scale = options.FontRenderingEmSize / options.GlyphTypeface.Metrics.DesignEmHeight;
    private readonly List<GlyphInfo> _glyphs = [];

    /// <summary>Glyph that the next one may be kerned to; -1 after anything but a letter.</summary>
    private int _previous = -1;

    public IReadOnlyList<GlyphInfo> Glyphs => _glyphs;

    public void Shape(ReadOnlySpan<char> text)
    {
        for (var index = 0; index < text.Length;)
        {
            var codepoint = Codepoint.ReadAt(text, index, out var length);
            if (codepoint.Value == '\t')
                AddTab(index);
            else if (codepoint.IsBreakChar || codepoint.IsDefaultIgnorable)
                AddInvisible(codepoint, index, text);
            else if (codepoint.GeneralCategory == GeneralCategory.NonspacingMark && _glyphs.Count > 0)
                AddMark(codepoint);
            else
                AddLetter(codepoint, index);
            index += length;
        }
    }

    private void AddTab(int cluster)
    {
        var space = Space();
        var width = options.IncrementalTabWidth > 0 ? options.IncrementalTabWidth : SpacesOfTab * Advance(space);
        _glyphs.Add(new GlyphInfo(space, cluster, width));
        _previous = -1;
    }

    /// <summary>A line feed belongs to the carriage return before it.</summary>
    private void AddInvisible(Codepoint codepoint, int index, ReadOnlySpan<char> text)
    {
        var belongsToBefore = codepoint.Value == '\n' && index > 0 && text[index - 1] == '\r';
        _glyphs.Add(new GlyphInfo(Space(), belongsToBefore ? index - 1 : index, 0));
        _previous = -1;
    }

    /// <summary>Stands over what it follows, without an advance.</summary>
    private void AddMark(Codepoint codepoint) => _glyphs.Add(new GlyphInfo(Glyph((int)codepoint.Value), _glyphs[^1].GlyphCluster, 0));

    private void AddLetter(Codepoint codepoint, int cluster)
    {
        var glyph = Glyph((int)codepoint.Value);
        if (_previous >= 0)
            Kern(_previous, glyph);
        _glyphs.Add(new GlyphInfo(glyph, cluster, Advance(glyph) + options.LetterSpacing));
        _previous = glyph;
    }

    /// <summary>Pairs are given from left to right; in text that runs to the left the later glyph stands left.</summary>
    private void Kern(int previous, int glyph)
    {
        var isRightToLeft = (options.BidiLevel & 1) != 0;
        var units = isRightToLeft ? _kerning?.Between(glyph, previous) : _kerning?.Between(previous, glyph);
        if (units is not (null or 0))
        {
            var last = _glyphs[^1];
            _glyphs[^1] = new GlyphInfo(last.GlyphIndex, last.GlyphCluster, last.GlyphAdvance + units.Value * _scale, last.GlyphOffset);
        }
    }

    private ushort Glyph(int character) => _typeface.CharacterToGlyphMap[character];

    private ushort Space() => Glyph(' ');

    private double Advance(ushort glyph) => _typeface.TryGetHorizontalGlyphAdvance(glyph, out var units) ? units * _scale : 0;
}
