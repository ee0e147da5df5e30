using Engraver.Samples.Geometry;

namespace Engraver.Samples.Drawings;

/// <summary>Single-stroke letters of lines and arcs, 1 high, standing on the origin: what a pointed tool engraves in one pass.</summary>
internal static class StrokeGlyphs
{
    private const double Gap = 0.25;

    private static readonly Dictionary<char, (double Width, Contour[] Strokes)> Glyphs = new()
    {
        ['I'] = (0, [Pen.At(0, 0).LineTo(0, 1).Lift()]),
        ['V'] = (0.7, [RoundFootedV()]),
        ['X'] = (0.65, [Pen.At(0, 0).LineTo(0.65, 1).Lift(), Pen.At(0, 1).LineTo(0.65, 0).Lift()]),
        ['C'] = (0.6, [Pen.At(0.6, 0.7).ArcTo(0, 0.7, 180).LineTo(0, 0.3).ArcTo(0.6, 0.3, 180).Lift()]),
        ['J'] = (0.5, [Pen.At(0.5, 1).LineTo(0.5, 0.25).ArcTo(0, 0.25, -180).Lift()]),
        ['R'] = (0.6, [Pen.At(0, 0).LineTo(0, 1).LineTo(0.33, 1).ArcTo(0.33, 0.46, -180).LineTo(0, 0.46).Lift(), Pen.At(0.33, 0.46).LineTo(0.6, 0).Lift()]),
        ['U'] = (0.6, [Pen.At(0, 1).LineTo(0, 0.3).ArcTo(0.6, 0.3, 180).LineTo(0.6, 1).Lift()]),
        ['1'] = (0.25, [Pen.At(0, 0.75).LineTo(0.25, 1).LineTo(0.25, 0).Lift()]),
        ['2'] = (0.6, [DigitTwo()]),
    };

    public static double WidthOf(string word, double height) => height * (word.Sum(letter => Glyphs[letter].Width) + (Gap * (word.Length - 1)));

    /// <summary>The strokes of a word of the given height, its first letter standing on the origin.</summary>
    public static IEnumerable<Contour> Write(string word, double height)
    {
        var x = 0.0;
        foreach (var letter in word)
        {
            var (width, strokes) = Glyphs[letter];
            foreach (var stroke in strokes)
            {
                yield return stroke.Moved(x, 0).Scaled(height);
            }

            x += width + Gap;
        }
    }

    /// <summary>Two legs into a small tangent arc, as an engraver draws it: no sharp turn at the foot.</summary>
    private static Contour RoundFootedV()
    {
        const double foot = 0.06;
        var (left, right, bottom) = (new Point(0, 1), new Point(0.7, 1), new Point(0.35, foot));
        var leg = bottom - left;
        var touch = leg.Degrees - double.RadiansToDegrees(Math.Asin(foot / leg.Length)) - 90;
        var onLeft = bottom + Point.Polar(foot, touch);
        var onRight = new Point((2 * bottom.X) - onLeft.X, onLeft.Y);
        return Pen.At(left).LineTo(onLeft).ArcTo(onRight, 2 * (-90 - touch)).LineTo(right).Lift();
    }

    /// <summary>The bowl leaves at 45 degrees, straight into the stem.</summary>
    private static Contour DigitTwo()
    {
        var bowl = new Point(0.3, 0.7);
        var leave = bowl + Point.Polar(bowl.X, -45);
        return Pen.At(0, bowl.Y).ArcTo(leave, -225).LineTo(leave.X - leave.Y, 0).LineTo(0.6, 0).Lift();
    }
}
