using Avalonia;
using Avalonia.Media;
using Avalonia.Media.TextFormatting;
using Avalonia.Media.TextFormatting.Unicode;

namespace Engraver.SoftwarePlatform.Text;

/// <summary>Shapes text from left to right in one font, one glyph for each character: character map, advances, pair kerning and single accents.</summary>
internal sealed class LineShaper(TextShaperOptions options)
{
    private const int SpacesOfTab = 4;

    private readonly GlyphTypeface _typeface = options.GlyphTypeface;
    private readonly PairKerning? _kerning = (options.GlyphTypeface.PlatformTypeface as SoftwareTypeface)?.Kerning;
    private readonly double _scale = options.FontRenderingEmSize / options.GlyphTypeface.Metrics.DesignEmHeight;
    private readonly MarkPlacement? _placement = (options.GlyphTypeface.PlatformTypeface as SoftwareTypeface)?.Marks;
    private readonly List<GlyphInfo> _glyphs = [];
    private readonly List<(int Mark, int Letter)> _marks = [];

    /// <summary>Glyph that the next one may be kerned to; -1 after anything but a letter.</summary>
    private int _previous = -1;

    /// <summary>Index of the glyph of <see cref="_previous"/>; marks may be between.</summary>
    private int _previousPlace;

    /// <summary>In the order of the text.</summary>
    public List<GlyphInfo> Glyphs => _glyphs;

    /// <summary>Adds the glyphs of a part of the text.</summary>
    public void Shape(ReadOnlySpan<char> text, int start, int length)
    {
        _previous = -1;
        for (var index = start; index < start + length;)
        {
            var codepoint = Codepoint.ReadAt(text, index, out var units);
            if (codepoint.Value == '\t')
                AddTab(index);
            else if (codepoint.IsBreakChar || codepoint.IsDefaultIgnorable)
                AddInvisible(codepoint, index, text);
            else if (codepoint.GeneralCategory == GeneralCategory.NonspacingMark && _glyphs.Count > 0)
                AddMark(codepoint);
            else
                AddLetter(codepoint, index);
            index += units;
        }
        foreach (var (mark, letter) in _marks)
            Place(mark, letter);
        _marks.Clear();
    }

    private void AddTab(int cluster)
    {
        var space = Space();
        var width = options.IncrementalTabWidth > 0 ? options.IncrementalTabWidth : SpacesOfTab * Advance(space);
        _glyphs.Add(new GlyphInfo(space, cluster, width));
        _previous = -1;
    }

    /// <summary>Adds a character without a glyph; a line feed belongs to the carriage return before it.</summary>
    private void AddInvisible(Codepoint codepoint, int index, ReadOnlySpan<char> text)
    {
        var belongsToBefore = codepoint.Value == '\n' && index > 0 && text[index - 1] == '\r';
        _glyphs.Add(new GlyphInfo(Space(), belongsToBefore ? index - 1 : index, 0));
        _previous = -1;
    }

    /// <summary>Adds a mark over the letter that it follows, without an advance.</summary>
    private void AddMark(Codepoint codepoint)
    {
        if (_previous >= 0)
            _marks.Add((_glyphs.Count, _previousPlace));
        _glyphs.Add(new GlyphInfo(Glyph((int)codepoint.Value), _glyphs[^1].GlyphCluster, 0));
    }

    /// <summary>Positions a mark relative to the end of its letter, after all advances are known.</summary>
    private void Place(int mark, int letter)
    {
        var (info, under) = (_glyphs[mark], _glyphs[letter]);
        if (_placement?.Find(under.GlyphIndex, info.GlyphIndex) is not { } place)
            return;
        _glyphs[mark] = new GlyphInfo(info.GlyphIndex, info.GlyphCluster, 0, new Vector(place.X * _scale - under.GlyphAdvance, -place.Y * _scale));
    }

    private void AddLetter(Codepoint codepoint, int cluster)
    {
        var glyph = Glyph((int)codepoint.Value);
        _glyphs.Add(new GlyphInfo(glyph, cluster, Advance(glyph) + options.LetterSpacing));
        if (_previous >= 0)
            Kern(glyph);
        _previous = glyph;
        _previousPlace = _glyphs.Count - 1;
    }

    /// <summary>Changes the advance of the letter before the last one.</summary>
    private void Kern(int glyph)
    {
        var units = _kerning?.Between(_previous, glyph);
        if (units is null or 0)
            return;
        var left = _glyphs[_previousPlace];
        _glyphs[_previousPlace] = new GlyphInfo(left.GlyphIndex, left.GlyphCluster, left.GlyphAdvance + units.Value * _scale, left.GlyphOffset);
    }

    private ushort Glyph(int character) => _typeface.CharacterToGlyphMap[character];

    private ushort Space() => Glyph(' ');

    private double Advance(ushort glyph) => _typeface.TryGetHorizontalGlyphAdvance(glyph, out var units) ? units * _scale : 0;
}
