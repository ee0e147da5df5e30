using System.Collections.Concurrent;

namespace Engraver.Fonts.Strokes;

/// <summary>The second weight of a stroke font: each stroke becomes two, at the same distance on both sides of it. The two lines are joined around the ends
/// with half circles and around corners with arcs, and are open where strokes meet, so the contours of a letter are closed and do not cross.</summary>
/// <remarks>Derived from the first weight and not drawn: one drawing of each letter, and any width, as the cutter needs it.</remarks>
public sealed class DoubleStrokeFont : ITextFont
{
    /// <summary>In thousandths of the cap height of the font: a bold letter of 700 units has lines 70 units apart.</summary>
    private const double UsualWidth = 100;

    private static readonly Lazy<DoubleStrokeFont> s_engraver = new(() => new DoubleStrokeFont("Engraver Double", StrokeFont.Engraver, StrokeFont.Engraver.Metrics.CapHeight * UsualWidth / 1000));

    private readonly ConcurrentDictionary<int, GlyphCurves?> _glyphs = new();
    private readonly ITextFont _single;

    /// <param name="single">A font of strokes of lines and arcs.</param>
    /// <param name="width">Between the two lines, in font units; positive.</param>
    public DoubleStrokeFont(string name, ITextFont single, double width)
    {
        ArgumentNullException.ThrowIfNull(single);
        if (single.IsOutline) throw new ArgumentException(single.Name, nameof(single));
        ArgumentOutOfRangeException.ThrowIfNegativeOrZero(width);
        if (!double.IsFinite(width)) throw new ArgumentOutOfRangeException(nameof(width));
        Name = name;
        Width = width;
        _single = single;
    }

    /// <summary>The double-stroke font of this program: <see cref="StrokeFont.Engraver"/> with lines a tenth of the cap height apart.</summary>
    public static DoubleStrokeFont Engraver => s_engraver.Value;

    public string Name { get; }

    /// <summary>Between the two lines, in font units.</summary>
    public double Width { get; }

    public bool IsOutline => false;

    public FontMetrics Metrics => _single.Metrics;

    public bool Contains(int codePoint) => _single.Contains(codePoint);

    public GlyphCurves? GlyphOf(int codePoint) =>
        _glyphs.GetOrAdd(codePoint, code => _single.GlyphOf(code) is { } glyph ? glyph with { Contours = StrokeSides.Of(glyph.Contours, Width / 2) } : null);

    public double KerningOf(int left, int right) => _single.KerningOf(left, right);
}
