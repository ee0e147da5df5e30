using System.Collections.Concurrent;
using System.Globalization;
using System.Text;
using Engraver.Fonts.Strokes;

namespace Engraver.Fonts.StrokeFiles;

/// <summary>A font of LibreCAD (LFF): text with the lines and true arcs of each character. A glyph is read when it is asked for: <see cref="GlyphOf"/> throws
/// a <see cref="BrokenFontException"/> if one of its lines is invalid.</summary>
public sealed class LffFont : ITextFont
{
    /// <summary>The height of a capital in every LFF font.</summary>
    private const double LetterHeight = 9;

    /// <summary>Of letters with a descender.</summary>
    private const double LetterDepth = 3;
    private const double UsualLineSpacing = 5.0 / 3;
    private const double MaxHeaderNumber = 1000;
    private const int MaxCopies = 16;

    private readonly ConcurrentDictionary<int, GlyphCurves> _glyphs = new();
    private readonly Dictionary<int, IReadOnlyList<string>> _lines = [];
    private readonly double _letterSpacing = 3;
    private readonly double _wordSpacing = 6.75;

    private LffFont(TextReader text, string name)
    {
        Name = name;
        var lineSpacing = 1.0;
        List<string>? glyph = null;
        while (text.ReadLine()?.Trim() is { } line)
        {
            if (line.StartsWith('#'))
            {
                var (key, value) = Property(line);
                if (key == "Name" && value.Length > 0) Name = value;
                else if (key == "LetterSpacing") _letterSpacing = HeaderNumber(value);
                else if (key == "WordSpacing") _wordSpacing = HeaderNumber(value);
                else if (key == "LineSpacingFactor") lineSpacing = HeaderNumber(value);
            }
            else if (line.StartsWith('['))
            {
                // Of two characters with the same code, the first one counts.
                glyph = [];
                _lines.TryAdd(CodeOf(line), glyph);
            }
            else if (line.Length > 0)
            {
                (glyph ?? throw new BrokenFontException("The file is not an LFF font: lines before the first character.")).Add(line);
            }
        }

        if (_lines.Count == 0) throw new BrokenFontException("The LFF font has no characters.");
        Metrics = new FontMetrics(LetterHeight + LetterDepth, LetterHeight, LetterHeight, LetterDepth, LetterHeight * UsualLineSpacing * lineSpacing);
    }

    public string Name { get; }

    public bool IsOutline => false;

    public FontMetrics Metrics { get; }

    /// <summary>The characters of the font, in order.</summary>
    public IEnumerable<int> CodePoints => _lines.Keys.Order();

    /// <param name="name">If the font has none of its own.</param>
    /// <exception cref="BrokenFontException">Not an LFF font, or an invalid header.</exception>
    public static LffFont Read(ReadOnlyMemory<byte> data, string name)
    {
        using var text = new StringReader(Encoding.UTF8.GetString(data.Span).TrimStart('\uFEFF'));
        return new LffFont(text, name);
    }

    /// <summary>True for a space too, which has a width and often no lines in the file.</summary>
    public bool Contains(int codePoint) => _lines.ContainsKey(codePoint) || IsSpace(codePoint) || _lines.ContainsKey(DiameterSign.Other(codePoint));

    public GlyphCurves? GlyphOf(int codePoint) => Contains(codePoint) ? _glyphs.GetOrAdd(codePoint, Draw) : null;

    /// <returns>0: LFF fonts have no pairs.</returns>
    public double KerningOf(int left, int right) => 0;

    private GlyphCurves Draw(int codePoint)
    {
        var strokes = new StrokeCollector();
        var written = _lines.ContainsKey(codePoint) ? codePoint : DiameterSign.Other(codePoint);
        if (_lines.ContainsKey(written)) Draw(written, strokes, 0);
        var contours = strokes.Finish();
        // The width of a letter is that of its lines.
        var advance = contours.Count == 0 ? _wordSpacing : contours.SelectMany(contour => Stroke.Of(contour).Pieces).SelectMany(piece => piece.Extremes()).Max(point => point.X) + _letterSpacing;
        return new GlyphCurves(advance, contours);
    }

    private void Draw(int codePoint, StrokeCollector strokes, int depth)
    {
        if (depth > MaxCopies) throw new BrokenFontException("Characters of the LFF font are copies of each other.");
        foreach (var line in _lines.GetValueOrDefault(codePoint) ?? throw new BrokenFontException($"The LFF font has no character {codePoint:X4} to copy."))
        {
            if (line.StartsWith('C')) Draw(Hexadecimal(line[1..]), strokes, depth + 1);
            else DrawLine(line, strokes);
        }
    }

    /// <summary>Vertices, each with the bulge of the arc that ends there.</summary>
    private static void DrawLine(string line, StrokeCollector strokes)
    {
        var isFirst = true;
        foreach (var vertex in line.Split(';', StringSplitOptions.TrimEntries | StringSplitOptions.RemoveEmptyEntries))
        {
            var fields = vertex.Split(',', StringSplitOptions.TrimEntries);
            if (fields.Length is not (2 or 3) || (fields.Length == 3 && !fields[2].StartsWith('A'))) throw new BrokenFontException($"A line of the LFF font cannot be read: {vertex}");
            var point = new FontPoint(Number(fields[0]), Number(fields[1]));
            if (isFirst) strokes.MoveTo(point);
            else strokes.ArcTo(point, fields.Length == 3 ? Number(fields[2][1..]) : 0);
            isFirst = false;
        }

        strokes.Finish();
    }

    private static bool IsSpace(int codePoint) => codePoint is 0x20 or 0xA0;

    private static (string Key, string Value) Property(string line) => line.TrimStart('#').Split(':', 2, StringSplitOptions.TrimEntries) is [var key, var value] ? (key, value) : ("", "");

    /// <param name="line">Such as <c>[0041] A</c> or <c>[#0041]</c>.</param>
    private static int CodeOf(string line) => Hexadecimal(line.TrimStart('[', '#').Split(']')[0]);

    private static int Hexadecimal(string text) =>
        int.TryParse(text.Trim(), NumberStyles.AllowHexSpecifier, CultureInfo.InvariantCulture, out var code) && code is >= 0 and <= 0x10FFFF ? code : throw new BrokenFontException($"A character code of the LFF font cannot be read: {text}");

    private static double Number(string text) =>
        double.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out var number) && double.IsFinite(number) ? number : throw new BrokenFontException($"A number of the LFF font cannot be read: {text}");

    private static double HeaderNumber(string text) => Number(text) is >= 0 and <= MaxHeaderNumber and var number ? number : throw new BrokenFontException($"A spacing of the LFF font is invalid: {text}");
}
