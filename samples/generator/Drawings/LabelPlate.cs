using Engraver.Samples.Dxf;
using Engraver.Samples.Geometry;

namespace Engraver.Samples.Drawings;

/// <summary>A label plate of 90 by 40 mm with texts: a name and a logo word, a serial number and a date, which are different on each plate.</summary>
internal static class LabelPlate
{
    private const string Plate = "PLATE";
    private const string Lettering = "TEXT";
    private const string Logo = "LOGO";

    public static DxfDocument Draw() => new(
        DxfVersion.R2018,
        DrawingUnit.Millimetres,
        [new(Plate, 7), new(Lettering, 3), new(Logo, 1)],
        [
            Shapes.RoundedRectangle(0, 0, 90, 40, 4).AsPolyline(Plate),
            new CircleEntity(Plate, new(6, 20), 2),
            new CircleEntity(Plate, new(84, 20), 2),
            new TextEntity(Logo, new(45, 27), 9, "CNC 2143") { Style = Logo, Centred = true },
            new TextEntity(Lettering, new(45, 17), 5, "[[csv:NAME]]") { Centred = true },
            new TextEntity(Lettering, new(14, 8), 3.5, "SERIAL [[n:0000]]"),
            new TextEntity(Lettering, new(54, 8), 3.5, "[[date:yyyy-MM-dd]]"),
        ])
    {
        Styles = [new(Logo, OutlineFontFile.FileName)],
    };
}
