using Engraver.Samples.Dxf;
using Engraver.Samples.Geometry;

namespace Engraver.Samples.Drawings;

/// <summary>A plate of 90 by 50 mm that is finished in one job with three tools: a name in an outline font, a serial number in strokes, holes, a pocket with an
/// island and an outline.</summary>
internal static class FinishedPlate
{
    private const string Outline = "OUTLINE";
    private const string Holes = "HOLES";
    private const string Pocket = "POCKET";
    private const string Name = "NAME";
    private const string Serial = "SERIAL";

    public static DxfDocument Draw() => new(
        DxfVersion.R2018,
        DrawingUnit.Millimetres,
        [new(Outline, 7), new(Holes, 1), new(Pocket, 5), new(Name, 3), new(Serial, 4)],
        [
            Shapes.RoundedRectangle(0, 0, 90, 50, 5).AsPolyline(Outline),
            new CircleEntity(Holes, new(6, 6), 1.5),
            new CircleEntity(Holes, new(84, 6), 1.5),
            new CircleEntity(Holes, new(84, 44), 1.5),
            new CircleEntity(Holes, new(6, 44), 1.5),
            Shapes.RoundedRectangle(12, 18, 28, 22, 4).AsPolyline(Pocket),
            new CircleEntity(Pocket, new(26, 29), 4),
            new TextEntity(Name, new(65, 24), 12, "CNC") { Style = Name, Centred = true },
            new TextEntity(Serial, new(45, 8), 4, "NO. [[n:0000]]") { Centred = true },
        ])
    {
        Styles = [new(Name, OutlineFontFile.FileName)],
    };
}
