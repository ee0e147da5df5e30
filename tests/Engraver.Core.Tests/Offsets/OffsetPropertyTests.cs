using Engraver.Core.Geometry;
using Engraver.Core.Offsets;
using Engraver.TestKit;
using static Engraver.Core.Tests.Offsets.OffsetShapes;

namespace Engraver.Core.Tests.Offsets;

/// <summary>Properties of every offset, independent of its shape.</summary>
public class OffsetPropertyTests
{
    private static readonly (string Name, OffsetContour Contour, double Distance)[] s_shapes =
    [
        ("rectangle", Rectangle(0, 0, 10, 4), 1.5), ("slot", Slot(20, 3), 2), ("rounded rectangle", RoundedRectangle(40, 20, 4), 5), ("star", Star(5, 20, 8), 2), ("gear", Gear(12, 16, 20), 1.2),
        ("self-crossing", Polygon((2, 10), (-1, 7), (-1, 15), (2, 12), (-0.0627, 12.3385), (1.0, 10.9937), (0.1442, 9.4608)), 0.1), ("bow tie", Polygon((0, 0), (10, 10), (10, 0), (0, 10)), 0.4),
    ];

    [Fact]
    public void Neither_the_drawn_direction_nor_the_first_segment_changes_in_and_out()
    {
        foreach (var (name, contour, distance) in s_shapes)
        {
            foreach (var side in new[] { OffsetSide.In, OffsetSide.Out })
            {
                var expected = Fingerprint(contour, distance, side);
                Assert.True(expected.Count > 0, name);
                for (var first = 0; first < contour.Segments.Count; first++)
                {
                    AreNear(expected, Fingerprint(StartingAt(contour, first), distance, side), name);
                    AreNear(expected, Fingerprint(Reversed(StartingAt(contour, first)), distance, side), name);
                }
            }
        }
    }

    [Fact]
    public void Left_of_a_contour_is_right_of_it_reversed()
    {
        foreach (var (name, contour, distance) in s_shapes)
        {
            AreNear(Fingerprint(contour, distance, OffsetSide.Left), Fingerprint(Reversed(contour), distance, OffsetSide.Right), name);
            var open = contour with { Segments = [.. contour.Segments.Skip(1)], Closed = false };
            AreNear(Fingerprint(open, distance, OffsetSide.Left), Fingerprint(Reversed(open), distance, OffsetSide.Right), name);
        }
    }

    /// <summary>A shape whose arcs all have a larger radius than the distance, outwards as inwards.</summary>
    [Theory]
    [InlineData(OffsetSide.In, OffsetSide.Out)]
    [InlineData(OffsetSide.Out, OffsetSide.In)]
    public void A_smooth_shape_offset_there_and_back_is_the_shape(OffsetSide there, OffsetSide back)
    {
        foreach (var contour in new[] { Circle(1, 2, 10), Slot(20, 5), RoundedRectangle(40, 20, 6) })
        {
            var once = ContourOffset.Offset([contour], 3.75, there, UsualOptions.Offset).Loops;
            var twice = ContourOffset.Offset([.. once.Select(loop => new OffsetContour(loop.Segments, true))], 3.75, back, UsualOptions.Offset);
            var (loop, witness) = (Assert.Single(twice.Loops), new OffsetWitness([contour]));

            Assert.Equal(contour.Segments.Count, loop.Segments.Count);
            Assert.All(loop.Segments, segment => Assert.All(new[] { 0.0, 0.3, 0.5, 0.9 }, at => Assert.True(witness.Distance(segment.PointAt(at).X, segment.PointAt(at).Y) < 1e-9)));
        }
    }

    [Fact]
    public void The_self_crossing_loop_can_be_offset_twice()
    {
        var once = ContourOffset.Offset([s_shapes[5].Contour], 0.1, OffsetSide.Out, UsualOptions.Offset).Loops;
        OffsetContour[] again = [.. once.Select(loop => new OffsetContour(loop.Segments, true))];

        Assert.Null(new OffsetWitness(again).FaultOfRegion(ContourOffset.Offset(again, 0.1, OffsetSide.Out, UsualOptions.Offset), 0.1, inside: false, 60));
    }

    [Theory]
    [InlineData(1.0)]
    [InlineData(9.9)]
    [InlineData(10.0)]
    [InlineData(15.0)]
    [InlineData(20.0)]
    [InlineData(25.0)]
    public void Fronts_of_islands_that_coincide_enclose_what_they_should(double distance)
    {
        OffsetContour[] plate = [Rectangle(0, 0, 100, 100), Rectangle(20, 20, 20, 20), Rectangle(60, 30, 20, 50)];

        foreach (var side in new[] { OffsetSide.In, OffsetSide.Out }) Assert.Null(new OffsetWitness(plate).FaultOfRegion(ContourOffset.Offset(plate, distance, side, UsualOptions.Offset), distance, side == OffsetSide.In, 80));
    }

    [Fact]
    public void Counted_squares_agree_with_the_area()
    {
        foreach (var (name, contour, distance) in s_shapes)
        {
            var result = ContourOffset.Offset([contour], distance, OffsetSide.Out, UsualOptions.Offset);
            var (area, counted) = (result.Loops.Sum(loop => loop.SignedArea), OffsetWitness.CountedArea(result, TestExtent.IsFull ? 400 : 200));
            Assert.True(Math.Abs(area - counted) < 0.01 * area, $"{name}: {area} and {counted}");
        }
    }

    [Fact]
    public void Vertices_twice_and_segments_without_length_change_nothing()
    {
        var (clean, doubled) = (Polygon((0, 0), (10, 0), (10, 4), (0, 4)), Polygon((0, 0), (0, 0), (10, 0), (10, 0), (10, 0), (10, 4), (0, 4), (0, 4)));

        AreNear(Fingerprint(clean, 1, OffsetSide.Out), Fingerprint(doubled, 1, OffsetSide.Out), "doubled");
        Assert.Empty(ContourOffset.Offset([Polygon((1, 1), (1, 1)), new OffsetContour([], true)], 1, OffsetSide.Both, UsualOptions.Offset).Loops);
    }

    /// <summary>Ends that differ by rounding are the same; tangent lines and arcs remain without a join.</summary>
    [Fact]
    public void Gaps_are_closed_without_joins_of_their_own()
    {
        var slot = Slot(20, 3);
        OffsetContour rounded = new([.. slot.Segments.Select(segment => segment.Kind == SegmentKind.Line ? Segment.FromLine(new Point2D(segment.Start.X + 1e-7, segment.Start.Y), new Point2D(segment.End.X - 1e-7, segment.End.Y + 1e-7)) : segment)], true);
        var loop = Assert.Single(ContourOffset.Offset([rounded], 1, OffsetSide.Out, UsualOptions.Offset).Loops);

        Assert.Equal((2, 2), (loop.Lines, loop.Arcs));
        Assert.True(loop.Closed);
    }

    [Fact]
    public void Tiny_steps_of_an_open_chain_are_followed()
    {
        var steps = Line([.. Enumerable.Range(0, 200).Select(i => (0.0125 * (i / 2), 0.0125 * ((i + 1) / 2)))]);

        foreach (var side in new[] { OffsetSide.Left, OffsetSide.Right }) Assert.Null(new OffsetWitness([steps]).FaultOfLoops(ContourOffset.Offset([steps], 2e-5, side, UsualOptions.Offset), 2e-5));
    }

    [Fact]
    public void An_ellipse_is_offset_within_the_curve_tolerance()
    {
        var ellipse = FreeCurves.Ellipse(0, 0, 10, 0.5, 0, 0, 360).ToCurve();
        var loop = ContourOffset.Offset([new OffsetContour([Segment.FromCurve(ellipse)], true)], 2, OffsetSide.Out, UsualOptions.Offset);

        Assert.InRange(loop.MaxDeviation, 0.0, 0.001);
        Assert.Equal((Math.PI * 50.0) + (2.0 * ellipse.PlanLength) + (4.0 * Math.PI), Assert.Single(loop.Loops).SignedArea, 1);
    }

    /// <summary>The arcs that replace it have radii of up to 400 m, for which the cosine of an angle is too inaccurate (1e-6: the whole contour
    /// vanished).</summary>
    [Theory]
    [InlineData(1e-3)]
    [InlineData(1e-6)]
    [InlineData(1e-4)]
    public void A_nearly_flat_ellipse_is_offset_as_the_line_it_nearly_is(double ratio)
    {
        var flat = FreeCurves.Ellipse(70, 0, 5, ratio, 0, 0, 360).ToCurve();
        var result = ContourOffset.Offset([new OffsetContour([Segment.FromCurve(flat)], true)], 0.5, OffsetSide.Out, UsualOptions.Offset);

        Assert.InRange(result.MaxDeviation, 0.0, 0.0011);
        Assert.InRange(Assert.Single(result.Loops).SignedArea, 10.0 + (Math.PI / 4.0) - 0.03, 10.0 + (Math.PI / 4.0) + 0.03 + (25.0 * Math.PI * ratio) + (10.0 * ratio));
    }

    private static List<(int Lines, int Arcs, double Length, double Area)> Fingerprint(OffsetContour contour, double distance, OffsetSide side)
    {
        var result = ContourOffset.Offset([contour], distance, side, UsualOptions.Offset);
        Assert.Null(new OffsetWitness([contour]).FaultOfLoops(result, distance));
        return [.. result.Loops.Select(loop => (loop.Lines, loop.Arcs, loop.Length, Area: Math.Abs(loop.SignedArea))).OrderBy(loop => Math.Round(loop.Area, 6)).ThenBy(loop => Math.Round(loop.Length, 6))];
    }

    private static void AreNear(List<(int Lines, int Arcs, double Length, double Area)> expected, List<(int Lines, int Arcs, double Length, double Area)> found, string name)
    {
        Assert.True(expected.Select(loop => (loop.Lines, loop.Arcs)).SequenceEqual(found.Select(loop => (loop.Lines, loop.Arcs))), $"{name}: {string.Join(' ', expected)} and {string.Join(' ', found)}");
        Assert.All(expected.Zip(found), pair => Assert.True(Math.Abs(pair.First.Length - pair.Second.Length) < 1e-8 && Math.Abs(pair.First.Area - pair.Second.Area) < 1e-8, name));
    }
}
