namespace Engraver.Fonts.Strokes;

/// <summary>A single-stroke font: the tool follows the middle of each line of a letter, in lines and true arcs. Its data is text (Data/shapes.txt describes
/// the format), read once.</summary>
public sealed class StrokeFont : ITextFont
{
    private const string Shapes = "shapes.txt";
    private const string Compositions = "compositions.txt";

    private static readonly Lazy<StrokeFont> s_engraver = new(ReadEmbedded);

    private readonly Dictionary<int, GlyphCurves> _glyphs;

    private StrokeFont(string name, StrokeFontReader data)
    {
        Name = name;
        Metrics = data.Metrics;
        _glyphs = data.Shapes.Where(shape => shape.Value.Mark is null).ToDictionary(shape => shape.Key, shape => shape.Value.ToCurves());
    }

    /// <summary>The font of this program.</summary>
    public static StrokeFont Engraver => s_engraver.Value;

    public string Name { get; }

    public bool IsOutline => false;

    public FontMetrics Metrics { get; }

    /// <summary>The files that <see cref="Engraver"/> is read from.</summary>
    internal static IReadOnlyList<string> DataFiles => [Shapes, Compositions];

    /// <summary>The characters of the font, in order.</summary>
    public IEnumerable<int> CodePoints => _glyphs.Keys.Order();

    /// <param name="shapes">The drawn shapes and the metrics.</param>
    /// <param name="compositions">Characters that are a shape with marks, or the shape of another character.</param>
    /// <exception cref="StrokeFontException">A line cannot be read; the exception has its file, its number and what is wrong.</exception>
    public static StrokeFont Read(string name, string shapesName, TextReader shapes, string compositionsName, TextReader compositions) =>
        new(name, StrokeFontReader.Read(shapesName, shapes, compositionsName, compositions));

    public bool Contains(int codePoint) => _glyphs.ContainsKey(codePoint);

    public GlyphCurves? GlyphOf(int codePoint) => _glyphs.GetValueOrDefault(codePoint);

    /// <returns>0: each letter has its own bearings.</returns>
    public double KerningOf(int left, int right) => 0;

    internal static Stream OpenData(string file) => typeof(StrokeFont).Assembly.GetManifestResourceStream("Engraver.Fonts.Strokes.Data." + file)!;

    private static StrokeFont ReadEmbedded()
    {
        using var shapes = new StreamReader(OpenData(Shapes));
        using var compositions = new StreamReader(OpenData(Compositions));
        return Read("Engraver", Shapes, shapes, Compositions, compositions);
    }
}
