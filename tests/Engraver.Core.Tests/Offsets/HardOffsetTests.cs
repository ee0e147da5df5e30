using Engraver.Core.Geometry;
using Engraver.Core.Offsets;
using Engraver.TestKit;

namespace Engraver.Core.Tests.Offsets;

/// <summary>All of <see cref="HardContours"/> in and out, reversed, from every start, with every join, in other sizes and positions.</summary>
public class HardOffsetTests
{
    public static TheoryData<int> Closed => [.. Enumerable.Range(0, HardContours.Closed.Count)];

    public static TheoryData<int> Open => [.. Enumerable.Range(0, HardContours.Open.Count)];

    [Theory]
    [MemberData(nameof(Closed))]
    public void What_is_enclosed_is_what_should_be(int number) => ForEach(number, (contours, distance, side) => new OffsetWitness(contours).FaultOfRegion(Offset(contours, distance, side), distance, side == OffsetSide.In, 40));

    [Theory]
    [MemberData(nameof(Closed))]
    public void Neither_direction_nor_start_matters(int number) => ForEach(number, (contours, distance, side) =>
    {
        var expected = Summary(Offset(contours, distance, side));
        var reversed = Summary(Offset([.. contours.Select(OffsetShapes.Reversed)], distance, side));
        if (reversed != expected) return $"{expected}, reversed {reversed}";
        for (var start = 1; start < contours[0].Segments.Count; start++)
        {
            var other = Summary(Offset([OffsetShapes.StartingAt(contours[0], start), .. contours[1..]], distance, side));
            if (other != expected) return $"{expected}, from {start} {other}";
        }

        return null;
    });

    [Theory]
    [MemberData(nameof(Closed))]
    public void Mitres_and_bevels_close_and_keep_their_distance_beside_what_was_drawn(int number) => ForEach(number, (contours, distance, side) =>
    {
        foreach (var join in new[] { OffsetJoin.Mitre, OffsetJoin.Bevel })
        {
            var result = ContourOffset.Offset(contours, distance, side, UsualOptions.OffsetWith(join));
            if (result.Unresolved.Count > 0 || result.Loops.Any(IsOpen)) return $"{join} is open";
            if (result.MaxDeviation > 2e-7) return $"{join} deviates by {result.MaxDeviation}"; // of arcs that are nearly lines, with radii of kilometres
        }

        return null;
    });

    /// <summary>A metre, a micrometre, a kilometre from the origin: the same loops.</summary>
    [Theory]
    [InlineData(1.0, 1e6)]
    [InlineData(1e-3, 0.0)]
    [InlineData(1e3, 0.0)]
    [InlineData(1.0, -12345.678)]
    public void Neither_size_nor_place_matters(double scale, double at)
    {
        for (var number = 0; number < HardContours.Closed.Count; number++)
        {
            ForEach(number, (contours, distance, side) =>
            {
                var (expected, moved) = (Offset(contours, distance, side), Offset([.. contours.Select(contour => HardContours.Placed(contour, scale, at))], distance * scale, side));
                if (moved.Unresolved.Count > 0 || moved.Loops.Any(IsOpen)) return "open";
                var (area, expectedArea) = (moved.Loops.Sum(loop => loop.SignedArea) / scale / scale, expected.Loops.Sum(loop => loop.SignedArea));
                return Math.Abs(area - expectedArea) > 1e-6 * (1.0 + Math.Abs(expectedArea)) ? $"{expectedArea} became {area}" : null;
            });
        }
    }

    [Theory]
    [MemberData(nameof(Open))]
    public void Both_sides_of_what_is_open_are_there_and_at_the_distance(int number)
    {
        var (name, contour, distances) = HardContours.Open[number];
        foreach (var distance in distances)
        {
            foreach (var side in new[] { OffsetSide.Left, OffsetSide.Right })
            {
                var (result, witness) = (Offset([contour], distance, side), new OffsetWitness([contour]));
                var fault = witness.FaultOfLoops(result, distance) ?? witness.Missing(result, distance, side == OffsetSide.Left);
                Assert.True(fault is null, FormattableString.Invariant($"{name}, {distance:R} {side}: {fault}"));
            }
        }
    }

    /// <summary>If it is thinner than its arcs can follow, it is a line forwards and back: a slot goes around it, and it has no inside.</summary>
    [Theory]
    [InlineData(1e-5)]
    [InlineData(1e-7)]
    [InlineData(1e-9)]
    [InlineData(1e-12)]
    public void A_flat_ellipse_is_a_line(double ratio)
    {
        var ellipse = new EllipseArc(default, new Vector3D(10.0, 0.0, 0.0), new Vector3D(0.0, 10.0 * ratio, 0.0), Angle.Zero, Angle.FullTurn).ToCurve();
        foreach (var (contour, outside, inside) in new[] { (new OffsetContour([Segment.FromCurve(ellipse)], true), OffsetSide.Right, OffsetSide.Left), (new OffsetContour([Segment.FromCurve(ellipse.Reversed())], true), OffsetSide.Left, OffsetSide.Right) })
        {
            Assert.Empty(Offset([contour], 1.0, OffsetSide.In).Loops);
            Assert.Empty(Offset([contour], 1.0, inside).Loops);
            Assert.Equal(40.0 + Math.PI, Assert.Single(Offset([contour], 1.0, OffsetSide.Out).Loops).SignedArea, 6);
            Assert.Equal(40.0 + Math.PI, Math.Abs(Assert.Single(Offset([contour], 1.0, outside).Loops).SignedArea), 6);
        }
    }

    /// <summary>Straight sides as CAD programs write them: radii from kilometres to many times the size of the solar system.</summary>
    [Theory]
    [InlineData(1e-7)]
    [InlineData(2e-8)]
    [InlineData(1e-10)]
    [InlineData(-1e-13)]
    public void Bulges_that_are_noise_change_nothing(double bulge)
    {
        foreach (var size in new[] { 1.0, 10.0, 300.0 })
        {
            var square = OffsetShapes.Chain(true, (0, 0, bulge), (size, 0, -bulge), (size, size, bulge / 2.0), (0, size, 0.0));

            Assert.Equal(0.64, Assert.Single(Offset([square], size / 10.0, OffsetSide.In).Loops).SignedArea / size / size, 6);
            Assert.Equal(1.4 + (0.01 * Math.PI), Assert.Single(Offset([square], size / 10.0, OffsetSide.Out).Loops).SignedArea / size / size, 6);
        }
    }

    [Fact]
    public void Each_segment_of_an_offset_knows_what_it_is_the_offset_of()
    {
        OffsetContour[] contours = [OffsetShapes.Rectangle(0, 0, 10, 4), OffsetShapes.Circle(5, 2, 1)];
        var loops = Offset(contours, 0.5, OffsetSide.Out).Loops;

        foreach (var loop in loops)
        {
            for (var i = 0; i < loop.Segments.Count; i++)
            {
                var (source, place) = (loop.Sources[i], loop.Segments[i].PointAt(0.5));
                Assert.Equal(0.5, Math.Abs(new OffsetWitness([contours[source.Contour] with { Segments = [contours[source.Contour].Segments[source.Segment]] }]).Distance(place.X, place.Y)), 9);
                Assert.Equal(source.Contour == 0 && loop.Segments[i].Kind != SegmentKind.Line, source.IsJoin);
            }
        }
    }

    /// <summary>From the drawing of an owl: a spline continues nearly straight in a line, which is followed by a line so short that it vanishes on the inside
    /// of their corner. The joint that is treated as smooth has one node, by which the long line is slightly too near; it is nevertheless not treated as
    /// covered.</summary>
    [Fact]
    public void A_loop_stays_closed_where_a_smooth_joint_and_a_short_line_follow_each_other()
    {
        var (start, joint, corner, next, end) = (new Point2D(53.11028, 7.538356), new Point2D(52.979315, 13.296333), new Point2D(52.9182, 13.587321), new Point2D(52.883275, 13.62259), new Point2D(51.137093, 18.437081));
        Segment[] segments =
        [
            Spline(start, new Point2D(53.450211, 9.457806), new Point2D(53.364788, 11.422332), joint), Segment.FromLine(joint, corner), Segment.FromLine(corner, next),
            Spline(next, new Point2D(52.502447, 15.310671), new Point2D(51.899572, 16.917805), end), Segment.FromLine(end, new Point2D(60.0, 18.5)), Segment.FromLine(new Point2D(60.0, 18.5), new Point2D(60.0, 7.5)), Segment.FromLine(new Point2D(60.0, 7.5), start),
        ];
        var result = Offset([new OffsetContour(segments, true)], 0.9497793700244718, OffsetSide.Out);
        var loop = Assert.Single(result.Loops);
        var box = segments.Aggregate(Bounds2D.Empty, (all, segment) => all.Union(segment.Bounds));

        Assert.Empty(result.Unresolved);
        Assert.InRange(result.MaxDeviation, 0.0, 2e-3);
        Assert.True(loop.Segments.Aggregate(Bounds2D.Empty, (all, segment) => all.Union(segment.Bounds)).Grown(-0.94).Contains(box));
    }

    private static Segment Spline(Point2D a, Point2D b, Point2D c, Point2D d) => Segment.FromCurve(new RationalCurve(SegmentKind.Spline, [new BezierSpan([a.X, a.Y, 0.0, 1.0, b.X, b.Y, 0.0, 1.0, c.X, c.Y, 0.0, 1.0, d.X, d.Y, 0.0, 1.0])]));

    private static void ForEach(int number, Func<OffsetContour[], double, OffsetSide, string?> faultOf)
    {
        var (name, contours, distances) = HardContours.Closed[number];
        foreach (var distance in distances)
        {
            foreach (var side in new[] { OffsetSide.In, OffsetSide.Out })
            {
                var fault = faultOf(contours, distance, side);
                Assert.True(fault is null, FormattableString.Invariant($"{name}, {distance:R} {side}: {fault}"));
            }
        }
    }

    private static OffsetResult Offset(OffsetContour[] contours, double distance, OffsetSide side) => ContourOffset.Offset(contours, distance, side, UsualOptions.Offset);

    private static bool IsOpen(OffsetLoop loop) => !loop.Closed || loop.Segments[^1].End != loop.Segments[0].Start;

    private static string Summary(OffsetResult result) => FormattableString.Invariant($"{result.Loops.Count} loops, area {result.Loops.Sum(loop => loop.SignedArea):0.######}, length {result.Loops.Sum(loop => loop.Length):0.####}");
}
