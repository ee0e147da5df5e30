using Engraver.Samples.Dxf;

namespace Engraver.Samples.Drawings;

/// <summary>The part that paper 001 works through: three lines and a half circle, 100 by 150 mm.</summary>
internal static class PaperPart
{
    private const string Layer = "PART";

    public static DxfDocument Draw() => new(DxfVersion.R2000, DrawingUnit.Millimetres, [new(Layer, 7)],
    [
        new LineEntity(Layer, new(50, 50), new(150, 50)),
        new LineEntity(Layer, new(150, 50), new(150, 150)),
        new ArcEntity(Layer, new(100, 150), 50, 0, 180),
        new LineEntity(Layer, new(50, 150), new(50, 50)),
    ]);
}
