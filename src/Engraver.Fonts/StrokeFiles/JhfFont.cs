using System.Globalization;
using System.Text;

namespace Engraver.Fonts.StrokeFiles;

/// <summary>A Hershey font (JHF): text, each character as pairs of letters that are coordinates. The first character of a file is the space, the others
/// follow in the order of ASCII.</summary>
public sealed class JhfFont : ITextFont
{
    private const int FirstCharacter = 0x20;
    private const int MaxCharacters = 4096;

    /// <summary>The columns of the number of a character, and of its number of pairs.</summary>
    private const int NumberColumns = 5, HeadColumns = 8;

    /// <summary>The letter for zero.</summary>
    private const char Zero = 'R';
    private const char First = ' ', Last = '~';
    private const string PenUp = " R";

    /// <summary>Y of the baseline, downwards; the height of a capital; the depth of a descender.</summary>
    private const int Baseline = 9, CapHeight = 21, Depth = 7;
    private const int Em = 32;
    private const double UsualLineSpacing = 5.0 / 3;

    private readonly IReadOnlyList<GlyphCurves> _glyphs;

    private JhfFont(IReadOnlyList<GlyphCurves> glyphs, string name)
    {
        Name = name;
        _glyphs = glyphs;
    }

    public string Name { get; }

    public bool IsOutline => false;

    public FontMetrics Metrics { get; } = new(Em, CapHeight, CapHeight, Depth, CapHeight * UsualLineSpacing);

    /// <summary>The characters of the font, in order.</summary>
    public IEnumerable<int> CodePoints => Enumerable.Range(FirstCharacter, _glyphs.Count);

    /// <param name="name">The file has none.</param>
    /// <exception cref="BrokenFontException">Not a Hershey font, or a broken one.</exception>
    public static JhfFont Read(ReadOnlyMemory<byte> data, string name)
    {
        var glyphs = new List<GlyphCurves>();
        using var text = new StringReader(Encoding.Latin1.GetString(data.Span));
        while (text.ReadLine() is { } line)
        {
            if (string.IsNullOrWhiteSpace(line)) continue;
            if (glyphs.Count == MaxCharacters) throw new BrokenFontException("The Hershey font has too many characters.");
            glyphs.Add(Draw(Pairs(line, text)));
        }

        return glyphs.Count > 0 ? new JhfFont(glyphs, name) : throw new BrokenFontException("The Hershey font has no characters.");
    }

    public bool Contains(int codePoint) => codePoint >= FirstCharacter && codePoint - FirstCharacter < _glyphs.Count;

    public GlyphCurves? GlyphOf(int codePoint) => Contains(codePoint) ? _glyphs[codePoint - FirstCharacter] : null;

    /// <returns>0: each letter has its own bearings.</returns>
    public double KerningOf(int left, int right) => 0;

    /// <summary>The pairs of a character, which may continue on the next lines.</summary>
    private static string Pairs(string line, TextReader following)
    {
        if (line.Length < HeadColumns || !IsNumber(line[..NumberColumns], out _) || !IsNumber(line[NumberColumns..HeadColumns], out var count) || count == 0)
            throw new BrokenFontException("The file is not a Hershey font.");
        var pairs = new StringBuilder(line, HeadColumns, line.Length - HeadColumns, 2 * count);
        while (pairs.Length < 2 * count && following.ReadLine() is { } next) pairs.Append(next);
        var all = pairs.ToString();
        if (all.Length < 2 * count || all[(2 * count)..].Trim().Length > 0) throw new BrokenFontException("A character of the Hershey font has another number of pairs than it states.");
        return all[..(2 * count)];
    }

    private static bool IsNumber(string text, out int number) => int.TryParse(text, NumberStyles.AllowLeadingWhite, CultureInfo.InvariantCulture, out number);

    /// <param name="pairs">Left and right edge first.</param>
    private static GlyphCurves Draw(string pairs)
    {
        var (left, right) = (Coordinate(pairs[0]), Coordinate(pairs[1]));
        var strokes = new StrokeCollector();
        var isDown = false;
        for (var i = 2; i < pairs.Length; i += 2)
        {
            if (pairs.AsSpan(i, 2).SequenceEqual(PenUp))
            {
                isDown = false;
                continue;
            }

            var point = new FontPoint(Coordinate(pairs[i]) - left, Baseline - Coordinate(pairs[i + 1]));
            if (isDown) strokes.LineTo(point);
            else strokes.MoveTo(point);
            isDown = true;
        }

        return new GlyphCurves(right - left, strokes.Finish());
    }

    private static int Coordinate(char letter) => letter is >= First and <= Last ? letter - Zero : throw new BrokenFontException("A coordinate of the Hershey font is not a letter.");
}
