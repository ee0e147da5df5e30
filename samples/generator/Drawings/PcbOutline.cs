using Engraver.Benchmarks.Stages;
using Engraver.Samples.Dxf;
using Engraver.Samples.Geometry;

namespace Engraver.Samples.Drawings;

/// <summary>A 100 by 76 circuit board in R12 without units: outline with notches, slots, holes, mouse bites and legend, in no order and either
/// direction.</summary>
internal static class PcbOutline
{
    private const string Board = "BOARD";
    private const string Cutouts = "CUTOUTS";
    private const string Drill = "DRILL";
    private const string Legend = "LEGEND";
    private const ulong Seed = 2143;

    public static DxfDocument Draw()
    {
        DxfEntity[] entities = [Outline().AsPolyline(Board), .. Slots(), .. Holes(), .. ChipLegend(), .. Words()];
        var random = new SeededSequence(Seed);
        random.Shuffle<DxfEntity>(entities);
        return new DxfDocument(DxfVersion.R12, DrawingUnit.Unitless, [new(Board, 7), new(Cutouts, 1), new(Drill, 5), new(Legend, 3)],
            [.. entities.Select(entity => random.Coin() ? entity.Reversed() : entity)]);
    }

    /// <summary>Board with an edge connector below (keyed by a narrow notch), a notch on the right and a cable bay on top.</summary>
    private static Contour Outline() => Shapes.Rounded(
    [
        new(0, 0, 3), new(25, 0, 1), new(25, -6, 0.5),
        new(40, -6, 0.5), new(40, 0, 0.9), new(42, 0, 0.9), new(42, -6, 0.5),
        new(70, -6, 0.5), new(70, 0, 1), new(100, 0, 3),
        new(100, 25, 1), new(95, 25, 1), new(95, 40, 1), new(100, 40, 1), new(100, 70, 3),
        new(62, 70, 1), new(62, 61, 2), new(44, 61, 2), new(44, 70, 1), new(0, 70, 3),
    ]);

    private static IEnumerable<DxfEntity> Slots() =>
    [
        .. Shapes.Slot(14, 22, 14, 50, 1.6).AsLinesAndArcs(Cutouts),
        .. Shapes.Slot(22, 12, 48, 12, 1.25).AsLinesAndArcs(Cutouts),
        .. Shapes.Slot(76, 48, 86, 58, 1.6).AsLinesAndArcs(Cutouts),
        Shapes.Slot(22, 60, 34, 60, 1).AsPolyline(Cutouts),
        .. Shapes.RoundedRectangle(64, 10, 24, 13, 2).AsLinesAndArcs(Cutouts),
    ];

    /// <summary>Mounting holes in the corners, and mouse bites where the board breaks out of its panel.</summary>
    private static IEnumerable<DxfEntity> Holes() =>
    [
        .. new Point[] { new(5, 5), new(95, 5), new(95, 65), new(5, 65) }.Select(at => new CircleEntity(Drill, at, 1.6)),
        .. Enumerable.Range(0, 12).Select(i => new CircleEntity(Drill, new(0.6, 30 + (0.9 * i)), 0.25)),
        .. Enumerable.Range(0, 12).Select(i => new CircleEntity(Drill, new(74 + (0.9 * i), 69.4), 0.25)),
    ];

    /// <summary>The chip's open outline (its ends at the pin 1 notch), its pins, and a trace symbol.</summary>
    private static IEnumerable<DxfEntity> ChipLegend()
    {
        var body = Pen.At(36, 40).LineTo(30, 40).LineTo(30, 26).LineTo(58, 26).LineTo(58, 40).LineTo(40, 40).ArcTo(36, 40, -180).Lift();
        var pins = Enumerable.Range(0, 8).Select(i => 33 + (i * 22.0 / 7)).SelectMany(x => new[] { PinAt(x, 24.8, 22.8), PinAt(x, 41.2, 43.2) });
        var resistor = Pen.At(64, 32).LineTo(67, 32).LineTo(68, 34).LineTo(70, 30).LineTo(72, 34).LineTo(74, 30).LineTo(75, 32).LineTo(78, 32).Lift();
        return [.. body.AsLinesAndArcs(Legend), .. pins, .. resistor.AsLinesAndArcs(Legend)];
    }

    private static LineEntity PinAt(double x, double from, double to) => new(Legend, new(x, from), new(x, to));

    private static IEnumerable<DxfEntity> Words() =>
    [
        .. WordAt("IC1", 40, 31.5), .. WordAt("R1", 69, 36.5), .. WordAt("J1", 33, -3.8),
        .. WordAt("J2", 54, -3.8), .. WordAt("U2", 22, 52), .. WordAt("C2", 66, 52),
    ];

    private static IEnumerable<DxfEntity> WordAt(string word, double x, double y) =>
        StrokeGlyphs.Write(word, height: 3).SelectMany(stroke => stroke.Moved(x, y).AsLinesAndArcs(Legend));
}
