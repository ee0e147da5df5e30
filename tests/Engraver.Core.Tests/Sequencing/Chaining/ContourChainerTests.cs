using Engraver.Core.Geometry;
using Engraver.Core.Sequencing.Chaining;
using Engraver.TestKit;
using FsCheck;
using FsCheck.Fluent;
using FsCheck.Xunit;

namespace Engraver.Core.Tests.Sequencing.Chaining;

public class ContourChainerTests
{
    private const double Tolerance = 0.01;

    [Property]
    public Property Loose_polylines_come_back_whole_however_they_are_shuffled_and_turned() =>
        Prop.ForAll(LoosePolylines.Any, loose =>
        {
            var result = ContourChainer.Chain(loose.Shuffled, Tolerance);
            return Fingerprint(loose.Polylines) == Fingerprint(result, loose.Shuffled);
        });

    [Property]
    public Property Every_segment_lands_in_exactly_one_contour_and_each_follows_the_one_before() =>
        Prop.ForAll(LoosePolylines.Any, loose =>
        {
            var contours = ContourChainer.Chain(loose.Shuffled, Tolerance).Contours;
            var rows = contours.SelectMany(contour => contour.Pieces.ToArray()).Select(piece => piece.Row).Order();
            return rows.SequenceEqual(Enumerable.Range(0, loose.Shuffled.Length)) && contours.All(contour => IsJoined(contour, loose.Shuffled));
        });

    [Property]
    public Property A_contour_runs_in_the_direction_of_its_lowest_row_and_closed_ones_begin_there() =>
        Prop.ForAll(LoosePolylines.Any, loose => ContourChainer.Chain(loose.Shuffled, Tolerance).Contours.All(contour =>
        {
            var pieces = contour.Pieces.ToArray();
            var lowest = pieces.MinBy(piece => piece.Row);
            return !lowest.Reversed && (!contour.Closed || pieces[0] == lowest);
        }));

    [Theory]
    [InlineData(-1e-9)]
    [InlineData(double.NegativeInfinity)]
    public void A_tolerance_below_zero_is_refused_also_where_there_is_nothing_to_join(double tolerance)
    {
        Assert.Throws<ArgumentOutOfRangeException>(() => ContourChainer.Chain([], tolerance));
        Assert.Throws<ArgumentOutOfRangeException>(() => ContourChainer.Chain([Segment.FromLine(new Point2D(0, 0), new Point2D(1, 0))], tolerance));
    }

    [Fact]
    public void Nothing_gives_nothing()
    {
        var result = ContourChainer.Chain([], Tolerance);

        Assert.Empty(result.Contours);
        Assert.Empty(result.Discontinuities);
    }

    [Theory]
    [InlineData(0.0099, 1)]
    [InlineData(0.0101, 2)]
    public void Ends_join_within_the_tolerance_and_not_beyond(double gap, int contours) =>
        Assert.Equal(contours, ContourChainer.Chain([Line(0, 0, 10, 0), Line(10 + gap, 0, 20, 5)], Tolerance).Contours.Count);

    [Fact]
    public void A_tolerance_of_zero_joins_equal_ends() =>
        Assert.Single(ContourChainer.Chain([Line(0, 0, 10, 0), Line(10, 0, 20, 5)], 0.0).Contours);

    [Fact]
    public void Joining_works_across_cell_borders_and_zero() =>
        Assert.Single(ContourChainer.Chain([Line(-5, -5, -0.004, -0.004), Line(0.002, 0.002, 5, 5)], Tolerance).Contours);

    [Fact]
    public void At_a_branch_the_straightest_continuation_is_taken()
    {
        var result = ContourChainer.Chain([Line(0, 0, 10, 0), Line(10, 0, 20, 10), Line(20, 1, 10, 0), Line(10, 0, 20, -5)], Tolerance);

        Assert.Equal([new ContourPiece(0, false), new ContourPiece(2, true)], result.Contours[0].Pieces.ToArray());
        Assert.Equal(1, result.Branches);
    }

    [Fact]
    public void Equally_straight_continuations_go_to_the_lower_row()
    {
        var result = ContourChainer.Chain([Line(0, 0, 10, 0), Line(20, -10, 10, 0), Line(10, 0, 20, 10)], Tolerance);

        Assert.Equal([new ContourPiece(0, false), new ContourPiece(1, true)], result.Contours[0].Pieces.ToArray());
    }

    [Fact]
    public void Closing_is_a_continuation_like_the_others()
    {
        Segment[] loopWithTail = [Line(0, 0, 10, 0), Line(10, 0, 10, 10), Line(10, 10, 0, 0), Line(0, 0, -10, -10)];

        var result = ContourChainer.Chain(loopWithTail, Tolerance);

        Assert.Equal((1, false), (result.Contours.Count, result.Contours[0].Closed)); // straight on into the tail
    }

    [Theory]
    [InlineData(20)]
    [InlineData(400)]
    public void In_a_sunburst_every_ray_goes_straight_through_the_middle(int rays)
    {
        var contours = ContourChainer.Chain(Rays(Enumerable.Range(0, rays).Select(i => 360.0 * i / rays)), Tolerance).Contours;

        Assert.Equal(rays / 2, contours.Count);
        Assert.All(contours, contour => Assert.Equal(rays / 2, Math.Abs(contour.Pieces.Span[0].Row - contour.Pieces.Span[1].Row)));
    }

    [Theory]
    [InlineData(21)]
    [InlineData(401)]
    public void Rays_in_any_directions_go_on_with_each_other_until_one_is_left_alone(int rays)
    {
        var random = new Random(rays);

        var contours = ContourChainer.Chain(Rays(Enumerable.Range(0, rays).Select(_ => 360.0 * random.NextDouble())), Tolerance).Contours;

        Assert.Equal((rays / 2) + 1, contours.Count);
    }

    [Fact]
    public void A_circle_is_a_contour_of_its_own_even_where_a_line_starts_on_it()
    {
        var circle = Segment.FromArc(new ArcSegment(default, 10, Angle.Zero, Angle.FullTurn));

        var result = ContourChainer.Chain([circle, Line(10, 0, 20, 0)], Tolerance);

        Assert.Equal([true, false], result.Contours.Select(contour => contour.Closed));
    }

    [Fact]
    public void An_arc_that_comes_back_to_its_start_is_closed()
    {
        var arc = Segment.FromArc(new ArcSegment(default, 10, Angle.Zero, Angle.FromDegrees(359.99)));

        Assert.True(Assert.Single(ContourChainer.Chain([arc], Tolerance).Contours).Closed);
    }

    [Theory]
    [InlineData(0.0)]
    [InlineData(0.004)]
    [InlineData(0.0099)]
    public void A_micro_segment_in_a_corner_neither_breaks_the_contour_nor_stays_behind(double size)
    {
        Segment[] square = [Line(0, 0, 10, 0), Line(10, 0, 10 + size, size), Line(10 + size, size, 10, 10), Line(10, 10, 0, 0)];

        var result = ContourChainer.Chain(square, Tolerance);

        Assert.True(Assert.Single(result.Contours).Closed);
        Assert.Equal([0, 1, 2, 3], result.Contours[0].Pieces.ToArray().Select(piece => piece.Row));
    }

    [Fact]
    public void A_micro_segment_is_taken_along_even_where_the_contour_could_go_straight_on_without_it()
    {
        var result = ContourChainer.Chain([Line(0, 0, 10, 0), Line(10.004, 0, 20, 0), Line(10, 0, 10.004, 0)], Tolerance);

        Assert.Equal([0, 2, 1], Assert.Single(result.Contours).Pieces.ToArray().Select(piece => piece.Row));
    }

    [Fact]
    public void A_curve_of_steps_shorter_than_the_tolerance_stays_in_order_however_its_rows_are_shuffled()
    {
        var stepOfRow = Enumerable.Range(0, 1000).Select(row => row * 7 % 1000).ToArray();
        var steps = stepOfRow.Select(i => Line(i * 0.002, 0, (i + 1) * 0.002, 0)).ToArray();

        var contour = Assert.Single(ContourChainer.Chain(steps, Tolerance).Contours);

        Assert.Equal(Enumerable.Range(0, 1000), contour.Pieces.ToArray().Select(piece => stepOfRow[piece.Row]));
        Assert.False(contour.Closed);
    }

    /// <summary>Rays whose outer ends are within the tolerance of each other (0.02), or whose every end is within it of every other: the number of comparisons
    /// of a step does not grow with the number of rays.</summary>
    [Theory]
    [InlineData(100.0)]
    [InlineData(0.03)]
    [InlineData(0.02)]
    [InlineData(0.005)]
    [InlineData(0.0009)]
    public void A_star_costs_so_much_for_each_ray_however_many_it_has(double radius)
    {
        const int Few = 2_000;
        var (few, many) = (ContourChainer.Chain(Star(Few, radius), Tolerance), ContourChainer.Chain(Star(4 * Few, radius), Tolerance));

        Assert.Equal(4 * Few, many.Contours.Sum(contour => contour.Pieces.Length));
        Assert.InRange(many.Comparisons, 4 * Few, 8 * few.Comparisons);
        Assert.InRange(many.Comparisons, 4 * Few, 4 * Few * 600L);
    }

    /// <summary>Thousands of copies of one line: all equally straight, the lowest row first.</summary>
    [Fact]
    public void Copies_of_a_line_are_gone_to_and_fro_in_the_order_of_their_rows()
    {
        const int Copies = 4_000;
        var result = ContourChainer.Chain([.. Enumerable.Repeat(Line(0, 0, 10, 0), Copies)], Tolerance);

        Assert.Equal(Copies / 2, result.Contours.Count);
        Assert.All(result.Contours, contour => Assert.Equal(contour.Pieces.Span[0].Row + 1, contour.Pieces.Span[1].Row));
        Assert.InRange(result.Comparisons, Copies, 600L * Copies);
    }

    /// <summary>Hundreds of ends within a few tolerances of each other, compared with the plain rule: every end is tested.</summary>
    [Property]
    public Property In_a_crowd_the_same_continuation_is_chosen_as_by_looking_at_every_end() =>
        Prop.ForAll(Gen.Choose(0, int.MaxValue).ToArbitrary(), seed =>
        {
            var random = new Random(seed);
            var (count, spread, longest) = (random.Next(150, 400), Tolerance * Math.Pow(10.0, random.NextDouble() - 0.5), random.Next(3) == 0 ? 2.0 * Tolerance : 10.0);
            var grid = random.Next(2) == 0 ? Tolerance / 4.0 : 0.0; // many exactly equal places and directions
            var segments = Enumerable.Range(0, count).Select(_ => Line(Near(), Near(), Near() + Far(), Near() + Far())).Where(line => line.Length > 0.0).ToArray();
            var result = ContourChainer.Chain(segments, Tolerance);

            return PlainChains.Of(segments, Tolerance).SequenceEqual(result.Contours.Select(contour => string.Join(' ', contour.Pieces.ToArray())));

            double Near() => Snapped((random.NextDouble() - 0.5) * spread);
            double Far() => Snapped(random.Next(3) * longest * random.NextDouble());
            double Snapped(double value) => grid > 0.0 ? Math.Round(value / grid) * grid : value;
        });

    [Fact]
    public void A_lone_segment_without_length_is_an_open_contour() =>
        Assert.False(Assert.Single(ContourChainer.Chain([Line(3, 3, 3, 3)], Tolerance).Contours).Closed);

    [Fact]
    public void Absurd_coordinates_end_and_lose_nothing() =>
        Assert.Equal(2, ContourChainer.Chain([Line(1e300, 0, -1e300, 1e300), Line(1, 1, 2, 2)], Tolerance).Contours.Sum(contour => contour.Pieces.Length));

    [Fact]
    public void The_gap_of_an_open_end_is_the_distance_to_the_nearest_other_open_end()
    {
        var ends = ContourChainer.Chain([Line(0, 0, 10, 0), Line(10.5, 0, 30, 0)], Tolerance).Discontinuities;

        Assert.Equal(new double?[] { 10.0, 0.5, 0.5, 19.5 }, ends.Select(end => end.Gap));
        Assert.Equal([0, 1, 0, 1], ends.Select(end => end.NearestRow));
        Assert.Equal([0.0, 10.0, 10.5, 30.0], ends.Select(end => end.Place.X));
    }

    private static Segment Line(double x1, double y1, double x2, double y2) => Segment.FromLine(new Point2D(x1, y1), new Point2D(x2, y2));

    /// <summary>Each a little longer than the previous one, so that they meet only in the middle.</summary>
    private static Segment[] Rays(IEnumerable<double> degrees) =>
        [.. degrees.Select((angle, i) => Segment.FromLine(Point2D.Origin, Point2D.Origin + Vector2D.FromPolar(50 + i, Angle.FromDegrees(angle))))];

    private static Segment[] Star(int rays, double radius) =>
        [.. Enumerable.Range(0, rays).Select(ray => Segment.FromLine(Point2D.Origin, Point2D.Origin + Vector2D.FromPolar(radius, Angle.FromDegrees(360.0 * ray / rays))))];

    private static bool IsJoined(Contour contour, Segment[] segments)
    {
        var pieces = contour.Pieces.ToArray();
        var next = contour.Closed ? pieces.Skip(1).Append(pieces[0]) : pieces.Skip(1);
        return pieces.Zip(next, (a, b) => a.EndIn(segments).IsNear(b.StartIn(segments), Tolerance)).All(joined => joined);
    }

    private static string Fingerprint(IEnumerable<IReadOnlyList<Segment>> polylines) =>
        string.Join('\n', polylines.Select(line => Describe(line[0].Start == line[^1].End, line)).Order(StringComparer.Ordinal));

    private static string Fingerprint(ChainResult result, Segment[] segments) => string.Join('\n', result.Contours
        .Select(contour => Describe(contour.Closed, [.. contour.Pieces.ToArray().Select(piece => segments[piece.Row])]))
        .Order(StringComparer.Ordinal));

    private static string Describe(bool closed, IReadOnlyList<Segment> segments) =>
        FormattableString.Invariant($"{closed} {segments.Count} {segments.Sum(segment => segment.Length):F6}");
}
