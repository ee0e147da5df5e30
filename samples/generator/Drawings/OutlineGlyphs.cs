using Engraver.Samples.Geometry;

namespace Engraver.Samples.Drawings;

/// <summary>Outline letters of lines and arcs, 10 high with 1.6 thick strokes, standing on the origin. Inner contours run clockwise.</summary>
internal static class OutlineGlyphs
{
    private const double Height = 10;
    private const double Stroke = 1.6;

    public static IReadOnlyDictionary<char, OutlineGlyph> All { get; } = new Dictionary<char, OutlineGlyph>
    {
        ['C'] = new(7, [LetterC()]),
        ['N'] = new(7, [LetterN()]),
        ['1'] = new(4, [DigitOne()]),
        ['2'] = new(6.5, [DigitTwo()]),
        ['3'] = new(6.5, [DigitThree()]),
        ['4'] = new(7.2, DigitFour()),
    };

    private static Contour LetterC()
    {
        const double outer = 3.5, inner = outer - Stroke, top = Height - outer;
        return Pen.At(2 * outer, top).ArcTo(0, top, 180).LineTo(0, outer).ArcTo(2 * outer, outer, 180)
            .LineTo(outer + inner, outer).ArcTo(Stroke, outer, -180).LineTo(Stroke, top).ArcTo(outer + inner, top, -180).Close();
    }

    private static Contour LetterN()
    {
        const double width = 7, right = width - Stroke, slant = 3.3;
        return Pen.At(0, 0).LineTo(Stroke, 0).LineTo(Stroke, Height - slant).LineTo(right, 0).LineTo(width, 0)
            .LineTo(width, Height).LineTo(right, Height).LineTo(right, slant).LineTo(Stroke, Height).LineTo(0, Height).Close();
    }

    private static Contour DigitOne()
    {
        const double right = 4, left = right - Stroke;
        return Pen.At(left, 0).LineTo(right, 0).LineTo(right, Height).LineTo(left + 0.2, Height)
            .LineTo(0, 8).LineTo(0, 6).LineTo(left, 7.9).Close();
    }

    /// <summary>The bowl runs tangentially into the slanting stem: outer and inner edge leave their circles at the same angle.</summary>
    private static Contour DigitTwo()
    {
        const double outer = 3.25, inner = outer - Stroke;
        var bowl = new Point(outer, Height - outer);
        var foot = new Point(0, Stroke);
        var toBowl = bowl - foot;
        var slope = toBowl.Degrees - double.RadiansToDegrees(Math.Asin(inner / toBowl.Length));
        var leave = slope - 90;
        var outerLeave = bowl + Point.Polar(outer, leave);
        var heel = outerLeave - (Point.Polar(1, slope) * ((outerLeave.Y - Stroke) / Math.Sin(double.DegreesToRadians(slope))));
        return Pen.At(0, bowl.Y).ArcAbout(bowl, leave - 180).LineTo(heel).LineTo(2 * outer, Stroke).LineTo(2 * outer, 0).LineTo(0, 0).LineTo(foot)
            .LineTo(bowl + Point.Polar(inner, leave)).ArcTo(Stroke, bowl.Y, 180 - leave).Close();
    }

    /// <summary>Two bowls that share the middle bar; the crotch on the right is where their outer circles cross.</summary>
    private static Contour DigitThree()
    {
        const double lower = 3.25, upper = 2.55, barStart = 2.3;
        var below = new Point(lower, lower);
        var above = new Point(lower, Height - upper);
        var distance = above.Y - below.Y;
        var rise = ((distance * distance) + (lower * lower) - (upper * upper)) / (2 * distance);
        var crotch = below + new Point(Math.Sqrt((lower * lower) - (rise * rise)), rise);
        var (barTop, barBottom) = (above.Y - upper + Stroke, below.Y + lower - Stroke);
        return Pen.At(0, lower).ArcTo(crotch, 180 + (crotch - below).Degrees).ArcTo(lower - upper, above.Y, 180 - (crotch - above).Degrees)
            .LineTo(lower - upper + Stroke, above.Y).ArcTo(lower, barTop, -270).LineTo(barStart, barTop)
            .LineTo(barStart, barBottom).LineTo(lower, barBottom).ArcTo(Stroke, lower, -270).Close();
    }

    private static Contour[] DigitFour()
    {
        const double stemRight = 6, stemLeft = stemRight - Stroke, barBottom = 2.2, barTop = barBottom + Stroke, peak = 4.2;
        const double slope = (Height - barTop) / peak;
        const double counterLeft = 2;
        return
        [
            Pen.At(stemLeft, 0).LineTo(stemRight, 0).LineTo(stemRight, barBottom).LineTo(7.2, barBottom).LineTo(7.2, barTop).LineTo(stemRight, barTop)
                .LineTo(stemRight, Height).LineTo(peak, Height).LineTo(0, barTop).LineTo(0, barBottom).LineTo(stemLeft, barBottom).Close(),
            Pen.At(counterLeft, barTop).LineTo(stemLeft, barTop + ((stemLeft - counterLeft) * slope)).LineTo(stemLeft, barTop).Close(),
        ];
    }
}
