using Engraver.Core.Geometry;
using Engraver.Core.Geometry.Biarcs;

namespace Engraver.Core.Tests.Geometry.Biarcs;

public sealed class ChordArcsTests
{
    private const double Tolerance = 1.0;

    private static readonly ChordArcs s_arcs = new(Tolerance, 10.0, 6e6);

    /// <summary>A rose of 9,206 chords; the goal is 332 arcs.</summary>
    [Fact]
    public void A_rose_of_9206_chords_becomes_few_arcs_within_the_tolerance()
    {
        var vertices = Closed(9206, turn => (40000.0 * Math.Cos(5.0 * turn), turn));
        var arcs = s_arcs.Cover(vertices, null, null);

        Assert.InRange(arcs.Count, 100, 332);
        AssertCovers(vertices, arcs);
    }

    [Theory]
    [InlineData(0.0)]
    [InlineData(0.3)]
    public void Chords_of_random_curves_are_covered_whatever_their_rounding(double rounding)
    {
        for (var seed = 1; seed <= 40; seed++)
        {
            var random = new Random(seed);
            var (waves, size) = (random.Next(1, 9), 2000.0 + (30000.0 * random.NextDouble()));
            var vertices = Closed(random.Next(3, 4000), turn => (size * (1.0 + (0.4 * Math.Sin(waves * turn))), turn + (0.1 * Math.Sin(3.0 * turn))));
            for (var i = 1; rounding > 0.0 && i + 1 < vertices.Length; i++) vertices[i] = new Point2D(vertices[i].X + (rounding * (random.NextDouble() - 0.5)), vertices[i].Y + (rounding * (random.NextDouble() - 0.5)));
            AssertCovers(vertices, s_arcs.Cover(vertices, null, null));
        }
    }

    [Fact]
    public void Chords_on_a_circle_are_one_arc_and_chords_on_a_line_one_line()
    {
        Point2D[] circle = [.. Enumerable.Range(0, 181).Select(i => new Point2D(5000.0 * Math.Cos(i * Math.PI / 180.0), 5000.0 * Math.Sin(i * Math.PI / 180.0)))];
        var arc = Assert.Single(s_arcs.Cover(circle, null, null)).Arc;
        Assert.Equal(1.0 / 5000.0, arc.Curvature, 1e-9);

        Point2D[] line = [new(0, 0), new(10, 5), new(300, 150), new(10000, 5000)];
        Assert.Equal(0.0, Assert.Single(s_arcs.Cover(line, null, null)).Arc.Curvature);
    }

    /// <summary>A fillet of chords between two lines: its arcs begin and end in their directions, so that there is no corner.</summary>
    [Theory]
    [InlineData(true, true)]
    [InlineData(true, false)]
    [InlineData(false, true)]
    public void The_arcs_have_the_directions_in_which_the_path_arrives_and_continues(bool hasLeaving, bool hasArriving)
    {
        Point2D[] fillet = [.. Enumerable.Range(0, 91).Select(i => new Point2D(8000.0 * Math.Sin(i * Math.PI / 180.0), -8000.0 * Math.Cos(i * Math.PI / 180.0)))];
        var (along, up) = (new Vector2D(1.0, 0.0), new Vector2D(0.0, 1.0));
        var arcs = s_arcs.Cover(fillet, hasLeaving ? along : null, hasArriving ? up : null);

        AssertCovers(fillet, arcs);
        Assert.InRange(arcs.Count, 1, 3);
        if (hasLeaving) Assert.Equal(0.0, arcs[0].Arc.StartTangent.Cross(along), 1e-9);
        if (hasArriving) Assert.InRange(Math.Abs(arcs[^1].Arc.EndTangent.Cross(up)), 0.0, 2e-3);
    }

    /// <summary>An S of two arcs with different radii, entered in a direction a little beside it.</summary>
    [Fact]
    public void A_direction_beside_the_curve_is_recovered()
    {
        List<Point2D> vertices = [.. Enumerable.Range(0, 60).Select(i => new Point2D(6000.0 * Math.Sin(i * 0.02), 6000.0 * (1.0 - Math.Cos(i * 0.02))))];
        var (end, direction) = (vertices[^1], Angle.FromRadians(59 * 0.02));
        var centre = end + (new Vector2D(direction.Sin(), -direction.Cos()) * 3000.0);
        vertices.AddRange(Enumerable.Range(1, 60).Select(i => centre + Vector2D.FromPolar(3000.0, direction + Angle.FromDegrees(90.0) - Angle.FromRadians(i * 0.02))));
        Point2D[] all = [.. vertices];
        foreach (var beside in (ReadOnlySpan<double>)[-0.01, 0.0, 0.01])
        {
            var arcs = s_arcs.Cover(all, Vector2D.FromPolar(1.0, Angle.FromRadians(beside)), Vector2D.FromPolar(1.0, direction - Angle.FromRadians(60 * 0.02)));
            AssertCovers(all, arcs);
            Assert.InRange(arcs.Count, 2, 12);
        }
    }

    [Fact]
    public void Chords_that_draw_no_curve_within_the_tolerance_stay()
    {
        Point2D[] zigzag = [.. Enumerable.Range(0, 30).Select(i => new Point2D(i * 100.0, i % 2 * 60.0))];
        var arcs = s_arcs.Cover(zigzag, null, null);
        AssertCovers(zigzag, arcs);
        Assert.InRange(arcs.Count, 25, 29);
    }

    /// <summary>By samples: every chord is covered once and in order, no sample of it is beside its arc, and arcs meet in one direction.</summary>
    private static void AssertCovers(Point2D[] vertices, IReadOnlyList<ChordArc> arcs)
    {
        Assert.Equal((0, vertices.Length - 1), (arcs[0].From, arcs[^1].To));
        Assert.Equal((vertices[0], vertices[^1]), (arcs[0].Arc.Start, arcs[^1].Arc.End));
        for (var i = 0; i < arcs.Count; i++)
        {
            var (arc, from, to) = arcs[i];
            if (i > 0) Assert.Equal((arcs[i - 1].To, arcs[i - 1].Arc.End), (from, arc.Start));
            var shape = arc.ToSegment();
            var next = i + 1 < arcs.Count ? arcs[i + 1].Arc.ToSegment() : shape;
            var before = i > 0 ? arcs[i - 1].Arc.ToSegment() : shape;
            for (var chord = from; chord < to; chord++)
            {
                for (var part = 0; part <= 8; part++)
                {
                    var place = vertices[chord] + ((vertices[chord + 1] - vertices[chord]) * (part / 8.0));
                    Assert.InRange(Math.Min(shape.DistanceTo(place), Math.Min(before.DistanceTo(place), next.DistanceTo(place))), 0.0, Tolerance * (1.0 + 1e-9));
                }
            }

            for (var part = 0; part <= 50; part++)
            {
                var place = shape.PointAt(part / 50.0);
                var (first, last) = (Math.Max(0, from - 1), Math.Min(vertices.Length - 1, to + 1));
                Assert.InRange(Enumerable.Range(first, last - first).Min(chord => new LineSegment(vertices[chord], vertices[chord + 1]).DistanceTo(place)), 0.0, Tolerance * (1.0 + 1e-9));
            }

            if (arc.Curvature != 0.0) Assert.InRange(Math.Abs(1.0 / arc.Curvature), 10.0, 6e6);
        }
    }

    private static Point2D[] Closed(int chords, Func<double, (double Radius, double Angle)> at)
    {
        var vertices = new Point2D[chords + 1];
        for (var i = 0; i <= chords; i++)
        {
            var (radius, angle) = at(i % chords * 2.0 * Math.PI / chords);
            vertices[i] = Point2D.Origin + Vector2D.FromPolar(radius, Angle.FromRadians(angle));
        }

        return vertices;
    }
}
