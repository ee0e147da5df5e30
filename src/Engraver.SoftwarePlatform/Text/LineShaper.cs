using Avalonia;
using Avalonia.Media.TextFormatting;
using Avalonia.Media.TextFormatting.Unicode;

namespace Engraver.SoftwarePlatform.Text;

/// <summary>Shapes text from left to right in one font, one glyph for each character: character map, advances, pair kerning and single accents.</summary>
internal sealed class LineShaper(TextShaperOptions options, int expectedLength)
{
    private const int SpacesOfTab = 4;

    private readonly SoftwareTypeface _typeface = (SoftwareTypeface)options.GlyphTypeface.PlatformTypeface;
    private readonly double _scale = options.FontRenderingEmSize / options.GlyphTypeface.Metrics.DesignEmHeight;
    private readonly List<GlyphInfo> _glyphs = new(expectedLength);
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
            var character = _typeface.Characters.Of(codepoint);
            switch (character.Kind)
            {
                case CharacterKind.Letter:
                    AddLetter(character, index);
                    break;
                case CharacterKind.Mark when _glyphs.Count > 0:
                    AddMark(character.Glyph);
                    break;
                case CharacterKind.Mark:
                    AddLetter(character, index);
                    break;
                case CharacterKind.Tab:
                    AddTab(character, index);
                    break;
                default:
                    AddInvisible(character, index, text);
                    break;
            }
            index += units;
        }
        foreach (var (mark, letter) in _marks)
            Place(mark, letter);
        _marks.Clear();
    }

    private void AddTab(CharacterEntry space, int cluster)
    {
        var width = options.IncrementalTabWidth > 0 ? options.IncrementalTabWidth : SpacesOfTab * (space.Advance * _scale);
        _glyphs.Add(new GlyphInfo(space.Glyph, cluster, width));
        _previous = -1;
    }

    /// <summary>Adds a character without a glyph; a line feed belongs to the carriage return before it.</summary>
    private void AddInvisible(CharacterEntry space, int index, ReadOnlySpan<char> text)
    {
        var belongsToBefore = text[index] == '\n' && index > 0 && text[index - 1] == '\r';
        _glyphs.Add(new GlyphInfo(space.Glyph, belongsToBefore ? index - 1 : index, 0));
        _previous = -1;
    }

    /// <summary>Adds a mark over the letter that it follows, without an advance.</summary>
    private void AddMark(ushort glyph)
    {
        if (_previous >= 0)
            _marks.Add((_glyphs.Count, _previousPlace));
        _glyphs.Add(new GlyphInfo(glyph, _glyphs[^1].GlyphCluster, 0));
    }

    /// <summary>Positions a mark relative to the end of its letter, after all advances are known.</summary>
    private void Place(int mark, int letter)
    {
        var (info, under) = (_glyphs[mark], _glyphs[letter]);
        if (_typeface.Marks.Find(under.GlyphIndex, info.GlyphIndex) is not { } place)
            return;
        _glyphs[mark] = new GlyphInfo(info.GlyphIndex, info.GlyphCluster, 0, new Vector(place.X * _scale - under.GlyphAdvance, -place.Y * _scale));
    }

    private void AddLetter(CharacterEntry letter, int cluster)
    {
        if (_previous >= 0)
            Kern(letter.Glyph);
        _previous = letter.Glyph;
        _previousPlace = _glyphs.Count;
        _glyphs.Add(new GlyphInfo(letter.Glyph, cluster, letter.Advance * _scale + options.LetterSpacing));
    }

    /// <summary>Changes the advance of the last letter by its distance to the next one.</summary>
    private void Kern(ushort next)
    {
        var units = _typeface.Kerning.Between(_previous, next);
        if (units == 0)
            return;
        var left = _glyphs[_previousPlace];
        _glyphs[_previousPlace] = new GlyphInfo(left.GlyphIndex, left.GlyphCluster, left.GlyphAdvance + units * _scale, left.GlyphOffset);
    }
}
