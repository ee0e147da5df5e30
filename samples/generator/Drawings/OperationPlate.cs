using Engraver.Samples.Dxf;
using Engraver.Samples.Geometry;

namespace Engraver.Samples.Drawings;

/// <summary>A plate of 90 by 60 mm for operations: an outline with a window, four holes, a pocket with an island, two scale lines and a text.</summary>
internal static class OperationPlate
{
    private const string Cut = "CUT";
    private const string Holes = "HOLES";
    private const string Pocket = "POCKET";
    private const string Mark = "MARK";

    public static DxfDocument Draw() => new(
        DxfVersion.R2018,
        DrawingUnit.Millimetres,
        [new(Cut, 7), new(Holes, 1), new(Pocket, 5), new(Mark, 3)],
        [
            Shapes.RoundedRectangle(0, 0, 90, 60, 6).AsPolyline(Cut),
            new CircleEntity(Cut, new(68, 34), 12),
            new CircleEntity(Holes, new(7, 7), 1.6),
            new CircleEntity(Holes, new(83, 7), 1.6),
            new CircleEntity(Holes, new(83, 53), 1.6),
            new CircleEntity(Holes, new(7, 53), 1.6),
            Shapes.RoundedRectangle(14, 20, 34, 28, 4).AsPolyline(Pocket),
            new CircleEntity(Pocket, new(31, 34), 6),
            new LineEntity(Mark, new(14, 14), new(48, 14)),
            new LineEntity(Mark, new(14, 12.5), new(14, 15.5)),
            new TextEntity(Mark, new(45, 5), 4, "CNC 2143") { Centred = true },
        ]);
}
