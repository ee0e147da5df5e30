using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.TestKit;

namespace Engraver.Core.Tests.Dxf;

/// <summary>Blocks in blocks under unequal scales, mirrors, arrays and tilted extrusions, compared with products of plain 4 x 4 matrices.</summary>
public class ExpansionTests
{
    private static readonly (int, object)[] s_content =
    [
        (0, "LINE"), (10, 1.0), (20, 2.0), (30, 3.0), (11, -4.0), (21, 5.0), (31, 0.5),
        (0, "CIRCLE"), (10, 2.0), (20, 1.0), (30, -1.0), (40, 3.0),
        (0, "SPLINE"), (70, 8), (71, 2), (72, 6), (73, 3), (40, 0.0), (40, 0.0), (40, 0.0), (40, 1.0), (40, 1.0), (40, 1.0), (10, 0.0), (20, 0.0), (30, 0.0), (10, 5.0), (20, 1.0), (30, 2.0), (10, 7.0), (20, -3.0), (30, 4.0),
    ];

    /// <summary>Positions in space of three parts of the content at the fractions 0, 1/4, 1/2 and 3/4 of the line, of the circle's turn, of the spline's
    /// parameter.</summary>
    private static readonly double[][][] s_points =
    [
        [.. Quarters.Select(t => new[] { 1.0 - (5.0 * t), 2.0 + (3.0 * t), 3.0 - (2.5 * t), 1.0 })],
        [.. Quarters.Select(t => new[] { 2.0 + (3.0 * Math.Cos(t * Math.Tau)), 1.0 + (3.0 * Math.Sin(t * Math.Tau)), -1.0, 1.0 })],
        [.. Quarters.Select(t => new[] { (10.0 * t * (1.0 - t)) + (7.0 * t * t), (2.0 * t * (1.0 - t)) - (3.0 * t * t), (4.0 * t * (1.0 - t)) + (4.0 * t * t), 1.0 })],
    ];

    private static double[] Quarters => [0.0, 0.25, 0.5, 0.75];

    [Fact]
    public void Every_copy_lies_where_the_product_of_the_matrices_puts_it()
    {
        for (var seed = 1; seed <= 150; seed++)
        {
            var (file, matrices) = Nest(new Random(seed));
            var drawing = DxfReading.Of(file);

            Assert.Equal(3 * matrices.Count, drawing.Entities.Count);
            for (var copy = 0; copy < matrices.Count; copy++)
            {
                for (var curve = 0; curve < 3; curve++) AssertThrough(drawing, (3 * copy) + curve, [.. s_points[curve].Select(point => Times(matrices[copy], point))], $"seed {seed}, copy {copy}, curve {curve}");
            }
        }
    }

    /// <summary>Points in space must be on the part; the plan of a circle may have become an ellipse.</summary>
    private static void AssertThrough(Drawing drawing, int entity, double[][] points, string what)
    {
        var part = drawing.Parts[drawing.Entities[entity].FirstPart];
        var size = points.Max(point => point.Max(Math.Abs)) + 1.0;
        foreach (var point in points) Assert.True(drawing.SegmentOf(part).DistanceTo(new Point2D(point[0], point[1])) <= 1e-9 * size, what);
        if (part.Kind == SegmentKind.Line) Assert.Equal(points[0][2], part.C, 1e-9 * size);
        else if (part.Kind == SegmentKind.Spline) Assert.Equal(points[0][2], drawing.Curves[part.CurveIndex].StartZ, 1e-9 * size);
    }

    /// <summary>One to four levels; each has one insert of the level below, the innermost has the content.</summary>
    private static (DxfText File, List<double[,]> Matrices) Nest(Random random)
    {
        var blocks = new List<(int, object)>(Block("L0", 1.0, -2.0, 0.5, s_content));
        var matrices = new List<double[,]> { Moved(-1.0, 2.0, -0.5) };
        var levels = random.Next(1, 5);
        for (var level = 1; level <= levels; level++)
        {
            var (insert, copies) = Insert($"L{level - 1}", random);
            matrices = [.. copies.SelectMany(copy => matrices.Select(inner => Times(copy, inner)))];
            if (level == levels) return (new DxfText().Header("AC1015", 4).Section("BLOCKS", [.. blocks]).Section("ENTITIES", insert).End(), matrices);
            double[] at = [random.Next(-5, 5), random.Next(-5, 5), random.Next(-5, 5)];
            blocks.AddRange(Block($"L{level}", at[0], at[1], at[2], insert));
            matrices = [.. matrices.Select(inner => Times(Moved(-at[0], -at[1], -at[2]), inner))];
        }

        throw new System.Diagnostics.UnreachableException();
    }

    private static (int, object)[] Block(string name, double x, double y, double z, ReadOnlySpan<(int, object)> content) => [(0, "BLOCK"), (2, name), (10, x), (20, y), (30, z), .. content, (0, "ENDBLK")];

    private static ((int, object)[] Pairs, List<double[,]> Copies) Insert(string block, Random random)
    {
        double[] scales = [1.0, -1.0, 2.0, 0.5, -3.0];
        var (x, y, z) = (random.Next(-50, 50), random.Next(-50, 50), random.Next(-5, 5));
        var (sx, sy, sz) = (scales[random.Next(5)], scales[random.Next(5)], scales[random.Next(5)]);
        var (turn, columns, rows, right, up) = (random.Next(-400, 400) / 2.0, random.Next(1, 4), random.Next(1, 3), random.Next(-9, 9), random.Next(-9, 9));
        double[][] directions = [[0, 0, 1], [0, 0, -1], [0.3, -0.2, 0.9], [0, 1, 0], [0.001, 0.001, 1]];
        var up3 = directions[random.Next(5)];
        var (sin, cos) = Math.SinCos(turn * Math.PI / 180.0);
        double[,] spin = { { cos, -sin, 0, 0 }, { sin, cos, 0, 0 }, { 0, 0, 1, 0 }, { 0, 0, 0, 1 } };
        double[,] scale = { { sx, 0, 0, 0 }, { 0, sy, 0, 0 }, { 0, 0, sz, 0 }, { 0, 0, 0, 1 } };
        var copies = new List<double[,]>();
        for (var copy = 0; copy < columns * rows; copy++) copies.Add(Times(System(up3), Times(Moved(x, y, z), Times(spin, Times(Moved(copy % columns * right, copy / columns * up, 0.0), scale)))));
        return ([(0, "INSERT"), (2, block), (10, x), (20, y), (30, z), (41, sx), (42, sy), (43, sz), (50, turn), (70, columns), (71, rows), (44, right), (45, up), (210, up3[0]), (220, up3[1]), (230, up3[2])], copies);
    }

    private static double[,] Moved(double x, double y, double z) => new[,] { { 1, 0, 0, x }, { 0, 1, 0, y }, { 0, 0, 1, z }, { 0, 0, 0, 1 } };

    /// <summary>The arbitrary axis algorithm exactly as in the DXF reference.</summary>
    private static double[,] System(double[] direction)
    {
        var n = Unit(direction);
        var ax = Unit(Math.Abs(n[0]) < 1.0 / 64.0 && Math.Abs(n[1]) < 1.0 / 64.0 ? Cross([0, 1, 0], n) : Cross([0, 0, 1], n));
        var ay = Unit(Cross(n, ax));
        return new[,] { { ax[0], ay[0], n[0], 0 }, { ax[1], ay[1], n[1], 0 }, { ax[2], ay[2], n[2], 0 }, { 0, 0, 0, 1 } };
    }

    private static double[] Unit(double[] v) => [.. v.Select(value => value / Math.Sqrt(v.Sum(part => part * part)))];

    private static double[] Cross(double[] a, double[] b) => [(a[1] * b[2]) - (a[2] * b[1]), (a[2] * b[0]) - (a[0] * b[2]), (a[0] * b[1]) - (a[1] * b[0])];

    private static double[] Times(double[,] m, double[] v) => [.. Enumerable.Range(0, 4).Select(row => Enumerable.Range(0, 4).Sum(column => m[row, column] * v[column]))];

    private static double[,] Times(double[,] a, double[,] b)
    {
        var product = new double[4, 4];
        for (var row = 0; row < 4; row++)
        {
            for (var column = 0; column < 4; column++) product[row, column] = Enumerable.Range(0, 4).Sum(k => a[row, k] * b[k, column]);
        }

        return product;
    }
}
