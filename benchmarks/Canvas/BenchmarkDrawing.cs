using Engraver.Core.Drawings;
using Engraver.Core.Geometry;

namespace Engraver.Benchmarks.Canvas;

/// <summary>A seeded sheet of irregular closed outlines, one in each cell of 4 units: lines, every tenth cell arcs, every twentieth a spline. The same
/// number gives the same sheet.</summary>
public static class BenchmarkDrawing
{
    private const double CellSize = 4.0;
    private const int Sides = 30;

    private static readonly Layer[] s_layers = [new("CUT", true, false, true), new("MARK", true, false, true), new("DEEP", true, false, true)];

    /// <param name="segments">Number of lines, arcs and splines together, at least 1.</param>
    public static Drawing Create(int segments)
    {
        var random = new Random(1); // Random may differ between runtimes, but figures are compared within one run only
        var (entities, parts, curves) = (new GrowingColumn<DrawingEntity>(), new GrowingColumn<DrawingPart>(), new List<RationalCurve>());
        var columns = (int)Math.Ceiling(Math.Sqrt((double)segments / Sides));
        for (var cell = 0; parts.Count < segments; cell++)
        {
            var middle = new Point2D(((cell % columns) + 0.5) * CellSize, ((cell / columns) + 0.5) * CellSize);
            var count = Math.Min(Sides, segments - parts.Count);
            if (cell % 20 == 7) AddSpline(entities, parts, curves, middle, random, cell);
            else AddOutline(entities, parts, middle, random, cell, count);
        }

        var balance = new ReadBalance(new Dictionary<string, int>(), 0, 0, [], [], new Dictionary<string, int>(), 0);
        return new Drawing("bench", 0, "", "", LengthUnit.AssumedMillimetres, s_layers, entities, parts, balance, []) { Curves = curves };
    }

    private static void AddOutline(GrowingColumn<DrawingEntity> entities, GrowingColumn<DrawingPart> parts, Point2D middle, Random random, int cell, int count)
    {
        var corners = Corners(middle, random);
        for (var side = 0; side < count; side++)
        {
            var entity = entities.Add(Entity(CurveType.Line, parts.Count, cell));
            var (from, to) = (corners[side], corners[(side + 1) % Sides]);
            if (cell % 10 == 3) parts.Add(DrawingPart.Arc(entity, ArcSegment.FromBulge(from, to, 0.3), 0.0));
            else parts.Add(DrawingPart.Line(entity, from.X, from.Y, 0.0, to.X, to.Y, 0.0));
        }
    }

    private static void AddSpline(GrowingColumn<DrawingEntity> entities, GrowingColumn<DrawingPart> parts, List<RationalCurve> curves, Point2D middle, Random random, int cell)
    {
        var corners = Corners(middle, random);
        var controls = corners.SelectMany(corner => new[] { corner.X, corner.Y, 0.0, 1.0 }).ToArray();
        var entity = entities.Add(Entity(CurveType.Spline, parts.Count, cell));
        curves.Add(new NurbsCurve(3, NurbsCurve.UniformKnots(3, Sides), controls).ToCurve()!);
        parts.Add(DrawingPart.FreeCurve(entity, SegmentKind.Spline, curves.Count - 1));
    }

    private static DrawingEntity Entity(CurveType type, int firstPart, int cell) => new() { Type = type, FirstPart = firstPart, PartCount = 1, Layer = cell % s_layers.Length };

    private static Point2D[] Corners(Point2D middle, Random random)
    {
        var corners = new Point2D[Sides];
        for (var i = 0; i < Sides; i++)
        {
            var radius = 0.45 * CellSize * (0.7 + (0.3 * random.NextDouble()));
            corners[i] = middle + Vector2D.FromPolar(radius, Angle.FromDegrees(360.0 * i / Sides));
        }

        return corners;
    }
}
