using Engraver.Samples.Dxf;
using Engraver.Samples.Geometry;

namespace Engraver.Samples.Drawings;

/// <summary>Contours within contours: a gear of two mirrored halves around rings, a star, another ring and a rounded triangle.</summary>
internal static class NestedLogo
{
    private const string Gear = "GEAR";
    private const string Rings = "RINGS";
    private const string Star = "STAR";
    private const string Core = "CORE";

    private const string GearHalf = "GEAR_HALF";
    private const string StarBlock = "STAR";
    private const string Button = "BUTTON";

    private const int Teeth = 18;
    private const double RootRadius = 52;
    private const double TipRadius = 60;
    private const int StarPoints = 5;

    public static DxfDocument Draw() => new(DxfVersion.R2000, DrawingUnit.Millimetres,
        [new(Gear, 30), new(Rings, 7), new(Star, 2), new(Core, 1)],
        [
            new InsertEntity(Gear, GearHalf, default),
            new InsertEntity(Gear, GearHalf, default) { ScaleX = -1 },
            Shapes.Ring(46).AsPolyline(Rings),
            new CircleEntity(Rings, default, 41),
            new InsertEntity(Star, StarBlock, default),
            .. Enumerable.Range(0, StarPoints).Select(ButtonAt),
            Shapes.Ring(12).AsPolyline(Core),
            Triangle().AsPolyline(Core),
        ])
    {
        Blocks =
        [
            new(GearHalf, [.. RightGearHalf().AsLinesAndArcs("0")]),
            new(StarBlock, [StarContour().AsPolyline("0")]),
            new(Button,
            [
                Shapes.Ring(10).AsPolyline("0"),
                new InsertEntity("0", StarBlock, default) { ScaleX = 0.2, ScaleY = 0.2 },
            ]),
        ],
    };

    /// <summary>From the middle of the root arc at the bottom, counter-clockwise to the one at the top; both ends are on the mirror line.</summary>
    private static Contour RightGearHalf()
    {
        const double pitch = 360.0 / Teeth;
        const double rootHalf = pitch * 0.22, flank = pitch * 0.1, tip = pitch - (2 * (rootHalf + flank));
        var pen = Pen.At(0, -RootRadius);
        for (var tooth = 0; tooth < Teeth / 2; tooth++)
        {
            var start = -90 + (tooth * pitch);
            pen.ArcTo(Point.Polar(RootRadius, start + rootHalf), tooth == 0 ? rootHalf : 2 * rootHalf)
                .LineTo(Point.Polar(TipRadius, start + rootHalf + flank))
                .ArcTo(Point.Polar(TipRadius, start + rootHalf + flank + tip), tip)
                .LineTo(Point.Polar(RootRadius, start + pitch - rootHalf));
        }

        return pen.ArcTo(0, RootRadius, rootHalf).Lift();
    }

    private static Contour StarContour() => Shapes.Rounded([.. Enumerable.Range(0, 2 * StarPoints).Select(i =>
    {
        var isPoint = i % 2 == 0;
        var at = Point.Polar(isPoint ? 38 : 18, 90 + (i * 180.0 / StarPoints));
        return new Corner(at.X, at.Y, isPoint ? 1.5 : 3);
    })]);

    /// <summary>A half-size button between two arms of the star.</summary>
    private static InsertEntity ButtonAt(int index)
    {
        var angle = 90 + ((index + 0.5) * 360 / StarPoints);
        return new InsertEntity(Core, Button, Point.Polar(30, angle)) { ScaleX = 0.5, ScaleY = 0.5, Rotation = angle - 90 };
    }

    private static Contour Triangle() => Shapes.Rounded([.. Enumerable.Range(0, 3).Select(i =>
    {
        var at = Point.Polar(9.5, 90 + (i * 120));
        return new Corner(at.X, at.Y, 2);
    })]);
}
