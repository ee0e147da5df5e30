using Engraver.Samples.Dxf;
using Engraver.Samples.Geometry;

namespace Engraver.Samples.Drawings;

/// <summary>A clock face of 140 mm with its two hands laid beside it. Angles are the clock's: degrees clockwise from twelve.</summary>
internal static class ClockDial
{
    private const string Cut = "CUT";
    private const string Rings = "RINGS";
    private const string Minutes = "MINUTES";
    private const string Hours = "HOURS";
    private const string Numerals = "NUMERALS";

    private const double NumeralHeight = 9;
    private const double NumeralRadius = 39;

    private static readonly string[] Roman = ["XII", "I", "II", "III", "IIII", "V", "VI", "VII", "VIII", "IX", "X", "XI"];

    public static DxfDocument Draw() => new(DxfVersion.R2000, DrawingUnit.Millimetres,
        [new(Cut, 7), new(Rings, 8), new(Minutes, 4), new(Hours, 1), new(Numerals, 3)],
        [
            new CircleEntity(Cut, default, 70),
            new CircleEntity(Rings, default, 67.5),
            new CircleEntity(Rings, default, 61),
            new CircleEntity(Rings, default, 34),
            .. Enumerable.Range(0, 60).Select(MinuteTick),
            .. Enumerable.Range(0, 12).SelectMany(hour => HourWedge(hour).AsLinesAndArcs(Hours)),
            .. Enumerable.Range(0, 12).SelectMany(Numeral),
            new CircleEntity(Cut, default, 2.5),
            .. Hand(x: 82, hub: 6, tip: 0.8, length: 62),
            .. Hand(x: 100, hub: 6, tip: 1.6, length: 44),
        ]);

    private static double Mathematical(double clockDegrees) => 90 - clockDegrees;

    private static LineEntity MinuteTick(int minute)
    {
        var angle = Mathematical(minute * 6);
        return new LineEntity(Minutes, Point.Polar(minute % 5 == 0 ? 62 : 63.5, angle), Point.Polar(66.5, angle));
    }

    /// <summary>A wedge that widens towards an outer edge concentric with the dial; the quarters are twice as wide.</summary>
    private static Contour HourWedge(int hour)
    {
        const double inner = 51, outer = 59.5;
        var half = hour % 3 == 0 ? 2.4 : 1.2;
        var angle = Mathematical(hour * 30);
        return Pen.At(Point.Polar(inner, angle - (half / 2))).LineTo(Point.Polar(outer, angle - half))
            .ArcTo(Point.Polar(outer, angle + half), 2 * half).LineTo(Point.Polar(inner, angle + (half / 2))).Close();
    }

    private static IEnumerable<DxfEntity> Numeral(int hour)
    {
        var word = Roman[hour];
        var left = -StrokeGlyphs.WidthOf(word, NumeralHeight) / 2;
        return StrokeGlyphs.Write(word, NumeralHeight)
            .SelectMany(stroke => stroke.Moved(left, NumeralRadius).Rotated(-30 * hour).AsLinesAndArcs(Numerals));
    }

    /// <summary>A tapered hand that points up, and the hole in its hub.</summary>
    private static IEnumerable<DxfEntity> Hand(double x, double hub, double tip, double length)
    {
        var centre = new Point(x, -length / 2);
        return [.. Shapes.Belt(centre, hub, centre + new Point(0, length), tip).AsLinesAndArcs(Cut), new CircleEntity(Cut, centre, 2.5)];
    }
}
