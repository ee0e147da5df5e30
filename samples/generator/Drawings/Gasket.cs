using Engraver.Samples.Dxf;
using Engraver.Samples.Geometry;

namespace Engraver.Samples.Drawings;

/// <summary>A flange gasket in inches: three ears blended by tangent lines, a bore, twelve bolts as a polar array and three vent grids as MINSERT.</summary>
internal static class Gasket
{
    private const string Outline = "OUTLINE";
    private const string Inside = "INSIDE";
    private const string Vents = "VENTS";
    private const string Marks = "MARKS";

    private const string Bolt = "BOLT";
    private const string Vent = "VENT";

    private const int Ears = 3;
    private const double BodyRadius = 2;
    private const double EarRadius = 0.45;
    private const double EarDistance = 2.4;

    private const int Bolts = 12;
    private const double BoltCircle = 1.72;

    public static DxfDocument Draw() => new(DxfVersion.R2000, DrawingUnit.Inches,
        [new(Outline, 7), new(Inside, 1), new(Vents, 4), new(Marks, 3)],
        [
            .. OuterContour().AsLinesAndArcs(Outline),
            new CircleEntity(Inside, default, 1.1),
            .. EachEar(angle => new CircleEntity(Inside, Point.Polar(EarDistance, angle), 0.2)),
            .. Enumerable.Range(0, Bolts).Select(BoltAt),
            .. EachEar(VentGrid),
        ])
    {
        Blocks = [BoltBlock(), new(Vent, [new CircleEntity("0", default, 0.03)])],
    };

    /// <summary>Body arc, tangent line, ear arc, tangent line, three times around.</summary>
    private static Contour OuterContour()
    {
        var touch = Shapes.TangentDegrees(BodyRadius, EarRadius, EarDistance);
        var pen = Pen.At(Point.Polar(BodyRadius, EarAngle(0) - touch));
        for (var ear = 0; ear < Ears; ear++)
        {
            var angle = EarAngle(ear);
            var centre = Point.Polar(EarDistance, angle);
            pen.LineTo(centre + Point.Polar(EarRadius, angle - touch)).ArcAbout(centre, 2 * touch).LineTo(Point.Polar(BodyRadius, angle + touch));
            if (ear < Ears - 1)
            {
                pen.ArcTo(Point.Polar(BodyRadius, EarAngle(ear + 1) - touch), BodyArc(touch));
            }
        }

        return pen.CloseWithArc(BodyArc(touch));
    }

    private static double BodyArc(double touch) => (360.0 / Ears) - (2 * touch);

    private static double EarAngle(int ear) => 90 + (ear * 360.0 / Ears);

    private static IEnumerable<DxfEntity> EachEar(Func<double, DxfEntity> draw) => Enumerable.Range(0, Ears).Select(ear => draw(EarAngle(ear)));

    /// <summary>A hole with a short index stroke on its outer side, so that a wrong rotation shows.</summary>
    private static DxfBlock BoltBlock() => new(Bolt,
    [
        new CircleEntity("0", default, 0.11),
        new LineEntity(Marks, new(0.13, 0), new(0.2, 0)),
    ]);

    private static InsertEntity BoltAt(int index)
    {
        var angle = 15 + (index * 360.0 / Bolts);
        return new InsertEntity(Inside, Bolt, Point.Polar(BoltCircle, angle)) { Rotation = angle };
    }

    /// <summary>Two rows of five vents between bore and bolts, turned with the ear above them.</summary>
    private static InsertEntity VentGrid(double earAngle)
    {
        var turn = earAngle - 90;
        return new InsertEntity(Vents, Vent, new Point(-0.2, 1.3).Rotated(turn)) { Rotation = turn, Columns = 5, Rows = 2, Spacing = 0.1 };
    }
}
