using System.Globalization;
using Engraver.Samples.Dxf;
using Engraver.Samples.Geometry;

namespace Engraver.Samples.Drawings;

/// <summary>An 80 by 30 mm plate with outline letters as blocks, and layers that must not be cut: off, frozen and not plotting.</summary>
internal static class Nameplate
{
    private const string Plate = "Außenkontur";
    private const string Holes = "Bohrungen Ø3";
    private const string Lettering = "Gravur 刻印";
    private const string Border = "Rahmen";
    private const string CentreLines = "Mittellinien";
    private const string Sketch = "Entwurf";
    private const string Note = "Hinweis";

    private const string Legend = "CNC 2143";
    private const double LetterGap = 1.5;
    private const double WordGap = 4;

    public static DxfDocument Draw()
    {
        DxfLayer[] layers =
        [
            new(Plate, 7), new(Holes, 1), new(Lettering, 3), new(Border, 5),
            new(CentreLines, 8, Off: true), new(Sketch, 9, Frozen: true), new(Note, 2, Plots: false),
        ];
        return new DxfDocument(DxfVersion.R2018, DrawingUnit.Millimetres, layers, [.. PlateParts(), .. LegendInserts(), .. Construction()])
        {
            Blocks = [.. Legend.Where(char.IsLetterOrDigit).Distinct().Select(LetterBlock)],
        };
    }

    private static IEnumerable<DxfEntity> PlateParts() =>
    [
        .. Shapes.RoundedRectangle(0, 0, 80, 30, 4).AsLinesAndArcs(Plate),
        new CircleEntity(Holes, new(5, 15), 1.5),
        new CircleEntity(Holes, new(75, 15), 1.5),
        Shapes.RoundedRectangle(2, 2, 76, 26, 2).AsPolyline(Border),
    ];

    /// <summary>Letters are on layer 0 of their block, so that they are drawn on the layer of the insert.</summary>
    private static DxfBlock LetterBlock(char letter) =>
        new(BlockName(letter), [.. OutlineGlyphs.All[letter].Contours.SelectMany(contour => contour.AsLinesAndArcs("0"))]);

    private static string BlockName(char letter) => string.Create(CultureInfo.InvariantCulture, $"GLYPH_{letter}");

    private static IEnumerable<DxfEntity> LegendInserts()
    {
        var width = Legend.Sum(Advance) - LetterGap;
        var x = 40 - (width / 2);
        foreach (var letter in Legend)
        {
            if (letter != ' ')
            {
                yield return new InsertEntity(Lettering, BlockName(letter), new(x, 10));
            }

            x += Advance(letter);
        }
    }

    private static double Advance(char letter) => letter == ' ' ? WordGap : OutlineGlyphs.All[letter].Width + LetterGap;

    private static IEnumerable<DxfEntity> Construction() =>
    [
        new LineEntity(CentreLines, new(-3, 15), new(83, 15)),
        new LineEntity(CentreLines, new(40, -3), new(40, 33)),
        new LineEntity(Sketch, new(0, 10), new(80, 10)),
        new LineEntity(Sketch, new(0, 20), new(80, 20)),
        new TextEntity(Note, new(0, -8), 3, "Messing 1.5 mm, Gravur 0.3 mm tief, 2 × Ø3"),
    ];
}
