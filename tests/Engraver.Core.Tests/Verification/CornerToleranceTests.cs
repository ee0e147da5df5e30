using Engraver.Core.Geometry;
using Engraver.Core.Sequencing;
using Engraver.Core.Verification;
using Engraver.TestKit;

namespace Engraver.Core.Tests.Verification;

/// <summary>The tool may round a drawn corner within the corner tolerance, and only there.</summary>
public class CornerToleranceTests
{
    private const double Tolerance = 0.05;

    /// <summary>A place within a count of the drawing is on it; in the region of a corner the deviation is a count.</summary>
    private const double Exact = 0.001 + 3e-5;

    private static readonly TraceTolerances s_tolerances = UsualOptions.Trace with { CornerTolerance = Tolerance, JoinTolerance = UsualOptions.JoinToleranceMm };

    public static TheoryData<double> Turns => [2.0, 10.0, 45.0, 90.0, 135.0, 170.0];

    [Theory]
    [MemberData(nameof(Turns))]
    public void A_corner_rounded_within_the_tolerance_is_as_drawn(double turn)
    {
        foreach (var share in (double[])[0.3, 1.0])
        {
            var drawn = Corner(turn);
            foreach (var verdict in Both(drawn, Rounded(drawn, share * Tolerance), s_tolerances))
            {
                Assert.InRange(verdict.MaxDeviation, 0.0, Exact);
                Assert.Equal(share * Tolerance * Math.Cos(turn * Math.PI / 360.0), verdict.CornerDeviation!.Value, 2e-4);
                Assert.Equal((0.0, 0.0), (verdict.MissingLength, verdict.ExtraLength));
            }
        }
    }

    [Theory]
    [MemberData(nameof(Turns))]
    public void The_same_corner_deviates_without_a_tolerance(double turn)
    {
        var drawn = Corner(turn);
        foreach (var verdict in Both(drawn, Rounded(drawn, Tolerance), s_tolerances with { CornerTolerance = 0.0 }))
        {
            Assert.Equal(Tolerance * Math.Cos(turn * Math.PI / 360.0), verdict.MaxDeviation, 2e-4);
            Assert.Null(verdict.CornerDeviation);
        }
    }

    [Theory]
    [MemberData(nameof(Turns))]
    public void A_larger_arc_is_found(double turn)
    {
        var drawn = Corner(turn);
        foreach (var verdict in Both(drawn, Rounded(drawn, 1.2 * Tolerance), s_tolerances)) Assert.True(verdict.MaxDeviation > s_tolerances.Deviation || turn > 150.0);
    }

    [Theory]
    [InlineData(0.5)]
    [InlineData(0.0)]
    public void A_cut_that_leaves_the_middle_of_a_side_is_found(double gap)
    {
        var drawn = Corner(90.0);
        var path = new List<Segment>
        {
            Segment.FromLine(new Point2D(-10, 0), new Point2D(-6, 0)),
            Segment.FromLine(new Point2D(-6, 0), new Point2D(-5, 0.009)),
            Segment.FromLine(new Point2D(-5, 0.009), new Point2D(-4 + gap, 0)),
            Segment.FromLine(new Point2D(-4 + gap, 0), default),
            drawn[1],
        };
        foreach (var verdict in Both(drawn, path, s_tolerances)) Assert.Equal(0.009, verdict.MaxDeviation, 1e-4);
    }

    /// <summary>A straight chamfer is inside the region as long as it passes the corner point within the tolerance.</summary>
    [Theory]
    [InlineData(0.9, true)]
    [InlineData(1.3, false)]
    public void A_chamfer_is_allowed_inside_the_region_only(double share, bool isAllowed)
    {
        var drawn = Corner(90.0);
        var length = share * Tolerance * Math.Sqrt(2.0);
        var path = new[] { Segment.FromLine(new Point2D(-10, 0), new Point2D(-length, 0)), Segment.FromLine(new Point2D(-length, 0), new Point2D(0, length)), Segment.FromLine(new Point2D(0, length), new Point2D(0, 10)) };
        foreach (var verdict in Both(drawn, path, s_tolerances)) Assert.Equal(isAllowed, verdict.MaxDeviation <= s_tolerances.Deviation);
    }

    [Fact]
    public void A_cut_beyond_a_corner_or_on_its_outside_is_found()
    {
        foreach (var turn in (double[])[20.0, 90.0, 160.0])
        {
            var drawn = Corner(turn);
            var ahead = Segment.FromLine(new Point2D(-10, 0), new Point2D(0.03, 0));
            var back = Segment.FromLine(ahead.End, drawn[1].PointAt(0.01));
            foreach (var verdict in Both(drawn, [ahead, back, Segment.FromLine(back.End, drawn[1].End)], s_tolerances)) Assert.InRange(verdict.MaxDeviation, 0.03 * Math.Sin(Math.Min(90.0, turn) * Math.PI / 180.0) - 1e-4, 0.03);
        }
    }

    [Fact]
    public void A_short_side_that_was_left_out_is_found()
    {
        foreach (var side in (double[])[0.02, 0.06, 0.2])
        {
            Segment[] drawn = [Segment.FromLine(new Point2D(-10, 0), default), Segment.FromLine(default, new Point2D(0, side)), Segment.FromLine(new Point2D(0, side), new Point2D(10, side))];
            foreach (var verdict in Both(drawn, [drawn[0]], s_tolerances, [drawn[2]])) Assert.InRange(verdict.MissingLength, side - (2.0 * s_tolerances.Coverage) - 1e-4, side);
        }
    }

    /// <summary>Both zones of a side cover it whole: it is cut where the tool passed both corners, and only there.</summary>
    [Theory]
    [InlineData(0.06)]
    [InlineData(0.2)]
    public void A_side_shorter_than_both_zones_is_cut_where_both_corners_were_passed(double side)
    {
        Segment[] drawn = [Segment.FromLine(new Point2D(-10, 0), default), Segment.FromLine(default, new Point2D(0, side)), Segment.FromLine(new Point2D(0, side), new Point2D(10, side))];
        var half = new Point2D(0, side / 2.0);
        var first = Rounded([drawn[0], Segment.FromLine(default, half)], Math.Min(Tolerance, (side / 2.0) * Math.Tan(Math.PI / 8.0)));
        var second = Rounded([Segment.FromLine(half, drawn[1].End), drawn[2]], Math.Min(Tolerance, (side / 2.0) * Math.Tan(Math.PI / 8.0)));

        foreach (var verdict in Both(drawn, [.. first, .. second], s_tolerances)) Assert.Equal((0.0, true), (verdict.MissingLength, verdict.MaxDeviation <= Exact));
        foreach (var verdict in Both(drawn, first, s_tolerances, [drawn[2]])) Assert.InRange(verdict.MissingLength, 0.3 * side, 0.55 * side);
    }

    [Fact]
    public void The_side_after_a_corner_is_missing_where_the_tool_stopped_at_the_corner()
    {
        foreach (var turn in (double[])[1.0, 5.0, 30.0, 120.0])
        {
            var whole = Tolerance / Math.Tan(turn * Math.PI / 720.0);
            Segment[] drawn = [Segment.FromLine(new Point2D(-10, 0), default), Segment.FromLine(default, default(Point2D) + Vector2D.FromPolar(0.9 * whole, Angle.FromDegrees(turn)))];
            foreach (var verdict in Both(drawn, [drawn[0]], s_tolerances)) Assert.InRange(verdict.MissingLength, 0.7 * drawn[1].Length, drawn[1].Length);
        }
    }

    /// <summary>Arcs as sides: a circle that touches both within the tolerance is found for each pair by bisection of its radius here.</summary>
    [Theory]
    [InlineData(3.0, 0.0, 60.0)]
    [InlineData(-3.0, 0.0, 60.0)]
    [InlineData(0.5, 0.5, 90.0)]
    [InlineData(-0.5, -0.5, 90.0)]
    [InlineData(2.0, -1.0, 30.0)]
    [InlineData(0.0, 40.0, 8.0)]
    [InlineData(0.3, 0.3, 150.0)]
    public void A_rounded_corner_of_arcs_is_as_drawn(double radius, double radiusSecond, double turn)
    {
        var drawn = BentCorner(radius, radiusSecond, turn);
        var path = RoundedBetween(drawn, Tolerance);

        foreach (var verdict in Both(drawn, path, s_tolerances))
        {
            Assert.InRange(verdict.MaxDeviation, 0.0, Exact);
            Assert.InRange(verdict.CornerDeviation!.Value, 0.1 * Tolerance, Tolerance);
            Assert.Equal((0.0, 0.0), (verdict.MissingLength, verdict.ExtraLength));
        }

        foreach (var verdict in Both(drawn, RoundedBetween(drawn, 1.3 * Tolerance), s_tolerances)) Assert.True(verdict.MaxDeviation > s_tolerances.Deviation || turn > 140.0);
        foreach (var verdict in Both(drawn, path, s_tolerances with { CornerTolerance = 0.0 })) Assert.True(verdict.MaxDeviation > s_tolerances.Deviation);
    }

    [Fact]
    public void A_kink_in_a_curve_is_a_corner()
    {
        // A spline of two spans with a turn of 90 degrees between them.
        var one = Span(new Point2D(-6, 2), new Point2D(-3, 0.4), new Point2D(-1, 0), default);
        var other = Span(default, new Point2D(0, 1), new Point2D(0.4, 3), new Point2D(2, 6));
        var curve = Segment.FromCurve(new RationalCurve(SegmentKind.Spline, [one, other]));
        var depth = 0.8 * Tolerance;
        var contact = depth / Math.Tan(Math.PI / 8.0);
        var arc = Rounded([Segment.FromLine(new Point2D(-1, 0), default), Segment.FromLine(default, new Point2D(0, 1))], depth)[1];
        var path = new List<Segment>();
        path.AddRange(Chords(one, t => one.PointAt(t).X < -contact));
        path.Add(Segment.FromLine(path[^1].End, arc.Start));
        path.Add(arc);
        var after = Chords(other, t => other.PointAt(t).Y > contact).ToArray();
        path.Add(Segment.FromLine(arc.End, after[0].Start));
        path.AddRange(after);

        foreach (var verdict in Both([curve], path, s_tolerances))
        {
            Assert.InRange(verdict.MaxDeviation, 0.0, 0.0035);
            Assert.Equal(depth * Math.Sqrt(0.5), verdict.CornerDeviation!.Value, 2e-3);
            Assert.Equal((0.0, 0.0), (verdict.MissingLength, verdict.ExtraLength));
        }

        foreach (var verdict in Both([curve], path, s_tolerances with { CornerTolerance = 0.0 })) Assert.InRange(verdict.MaxDeviation, 0.02, 0.04);
    }

    /// <summary>More seeds by <c>ENGRAVER_JUDGE_SEEDS=1000</c>.</summary>
    [Fact]
    public void Spans_and_samples_are_judged_alike()
    {
        var seeds = TestExtent.Cases(perCommit: 40, full: 400, "ENGRAVER_JUDGE_SEEDS");
        for (var seed = 0; seed < seeds; seed++)
        {
            var random = new Random(seed);
            var (drawn, place, angle) = (new List<Segment>(), default(Point2D), 0.0);
            for (var i = 0; i < 5; i++)
            {
                angle += random.Next(-160, 160);
                var end = place + Vector2D.FromPolar(0.05 + random.NextDouble(), Angle.FromDegrees(angle));
                drawn.Add(Segment.FromLine(place, end));
                place = end;
            }

            var path = new List<Segment> { drawn[0] };
            for (var i = 1; i < drawn.Count; i++)
            {
                var depth = Tolerance * random.NextDouble() * 1.5;
                var turn = Math.Abs(path[^1].EndTangent.TurnTo(drawn[i].StartTangent).Radians);
                var contact = Math.Min(Math.Min(depth / Math.Tan(turn / 4.0), 0.9 * path[^1].Length), drawn[i].Length / 2.0);
                var rounded = Rounded([path[^1], drawn[i]], contact * Math.Tan(turn / 4.0));
                path.RemoveAt(path.Count - 1);
                path.AddRange(rounded);
            }

            if (Both(drawn, path, s_tolerances) is not [var spans, var samples]) continue;

            Assert.True(Math.Abs(samples.MaxDeviation - spans.MaxDeviation) <= 5e-4, $"seed {seed}: {samples} {spans}");
            Assert.True(Math.Abs(samples.CornerDeviation!.Value - spans.CornerDeviation!.Value) <= 1e-3, $"seed {seed}: {samples} {spans}");
            Assert.True(Math.Abs(samples.MissingLength - spans.MissingLength) <= 0.05, $"seed {seed}: {samples} {spans}");
            Assert.True(Math.Abs(samples.ExtraLength - spans.ExtraLength) <= 0.02, $"seed {seed}: {samples} {spans}");
        }
    }

    /// <summary>Two lines crossed by a third one through their common point: the tool rounds from one to the other.</summary>
    [Fact]
    public void A_corner_on_another_line_is_rounded_too()
    {
        var corner = Corner(90.0);
        Segment[] drawn = [.. corner, Segment.FromLine(new Point2D(-5, 5), new Point2D(5, -5)), Segment.FromLine(new Point2D(-5, -5), new Point2D(5, 5))];
        foreach (var verdict in Both(drawn, Rounded(corner, Tolerance), s_tolerances, [drawn[2]], [drawn[3]])) Assert.Equal((true, 0.0), (verdict.MaxDeviation <= Exact, verdict.MissingLength));
    }

    [Fact]
    public void Ends_within_the_join_tolerance_are_a_corner()
    {
        Segment[] drawn = [Segment.FromLine(new Point2D(-10, 0), new Point2D(-0.006, 0)), Segment.FromLine(new Point2D(0, 0.006), new Point2D(0, 10))];
        foreach (var verdict in Both(drawn, Rounded(Corner(90.0), Tolerance), s_tolerances)) Assert.Equal((true, 0.0), (verdict.MaxDeviation <= s_tolerances.Deviation, verdict.MissingLength));
        foreach (var verdict in Both(drawn, Rounded(Corner(90.0), Tolerance), s_tolerances with { JoinTolerance = 0.0 })) Assert.True(verdict.MaxDeviation > s_tolerances.Deviation);
    }

    /// <summary>The same with heights, at the depth of the corner, above it and in an earlier pass; the side of another depth in the same place stays
    /// missing.</summary>
    [Fact]
    public void A_corner_is_rounded_at_its_own_depth()
    {
        var corner = Corner(90.0);
        var rounded = Rounded(corner, Tolerance);
        StrokeMove[] drawing = [.. corner.Select(side => new StrokeMove(side, 0, -1.0, -1.0))];
        StrokeMove[] both = [.. drawing, .. corner.Select(side => new StrokeMove(side, 0, -3.0, -3.0))];

        var found = InSpace(drawing, rounded, -1.0);
        Assert.InRange(found.MaxDeviation, 0.0, Exact);
        Assert.Equal(Tolerance * Math.Sqrt(0.5), found.CornerDeviation!.Value, 2e-4);
        Assert.Equal((0.0, 0.0), (found.MissingLength, found.ExtraLength));

        Assert.Equal(0.02, InSpace(drawing, rounded, -0.98).MaxDeviation, 1e-4);
        Assert.InRange(InSpace(drawing, Rounded(corner, 1.3 * Tolerance), -1.0).MaxDeviation, 0.01, 0.02);
        Assert.Equal(Tolerance * Math.Sqrt(0.5), InSpace(drawing, rounded, -1.0, s_tolerances with { CornerTolerance = 0.0 }).MaxDeviation, 2e-4);
        Assert.Equal(20.0, InSpace(both, rounded, -1.0).MissingLength, 0.01);
        Assert.InRange(InSpace(drawing, rounded, -0.5, depthPerPass: 0.5).MaxDeviation, 0.0, Exact);
        Assert.Equal(20.0, InSpace(drawing, rounded, -0.5, depthPerPass: 0.5).MissingLength, 0.01);
    }

    [Fact]
    public void The_places_of_a_trace_deviate_from_the_region_of_the_corner()
    {
        var corner = Corner(90.0);
        var apex = Rounded(corner, Tolerance)[1].PointAt(0.5);
        foreach (var (tolerances, deviation) in (ReadOnlySpan<(TraceTolerances?, double)>)[(s_tolerances, 0.001), (null, Tolerance * Math.Sqrt(0.5))])
        {
            var builder = new RunTraceBuilder(corner, rounding: tolerances);
            builder.Add(new TraceSample(0.0, apex.X, apex.Y, Cutting: true));
            Assert.Equal(deviation, builder.ToTrace("record").Places[0].DeviationMm, 1e-9);
        }
    }

    [Fact]
    public void A_pass_has_its_own_deviation_at_corners()
    {
        var corner = Corner(90.0);
        var judge = new PassJudge([new JudgedStroke(0, [.. corner.Select(side => new StrokeMove(side, 0))])], own => new TraceJudge([.. own.Select(move => move.Segment)], s_tolerances), 0.1);
        foreach (var part in Rounded(corner, Tolerance)) judge.Add(new TraceSpan(0, 1, 1000, part, true));

        Assert.Equal(Tolerance * Math.Sqrt(0.5), judge.Measured()[0]!.CornerDeviation!.Value, 2e-4);
        Assert.Equal(judge.Measured()[0]!.CornerDeviation, judge.Verdict().CornerDeviation);
    }

    private static TraceVerdict InSpace(StrokeMove[] drawing, Segment[] path, double z, TraceTolerances? tolerances = null, double? depthPerPass = null)
    {
        var judge = new HeightJudge(drawing, 0.0, depthPerPass, tolerances ?? s_tolerances);
        judge.Add(new TraceSample(0, path[0].Start.X, path[0].Start.Y, false, 5.0));
        foreach (var part in path)
        {
            var steps = 2 * (int)Math.Ceiling(part.Length / 0.004);
            for (var i = 0; i <= steps; i++) judge.Add(new TraceSample(i, part.PointAt((double)i / steps).X, part.PointAt((double)i / steps).Y, true, z));
        }

        return judge.Verdict();
    }

    private static BezierSpan Span(params Point2D[] control) => new([.. control.SelectMany(place => (double[])[place.X, place.Y, 0.0, 1.0])]);

    private static IEnumerable<Segment> Chords(BezierSpan span, Func<double, bool> isIn)
    {
        const int Count = 4000;
        for (var i = 0; i < Count; i++)
        {
            if (isIn((double)i / Count) && isIn((i + 1.0) / Count)) yield return Segment.FromLine(span.PointAt((double)i / Count), span.PointAt((i + 1.0) / Count));
        }
    }

    /// <summary>A side of radius 0 is a line; a positive radius bends to the inside of the turn.</summary>
    private static Segment[] BentCorner(double radius, double radiusSecond, double turn)
    {
        var leaving = Angle.FromDegrees(turn);
        return [Side(default, Angle.FromDegrees(180), -radius).Reversed(), Side(default, leaving, radiusSecond)];
    }

    /// <summary>From a place in a direction; a positive radius bends left.</summary>
    private static Segment Side(Point2D from, Angle direction, double radius)
    {
        if (radius == 0.0) return Segment.FromLine(from, from + Vector2D.FromPolar(10, direction));
        var toCentre = direction + Angle.FromDegrees(radius > 0.0 ? 90 : -90);
        return Segment.FromArc(new ArcSegment(from + Vector2D.FromPolar(Math.Abs(radius), toCentre), Math.Abs(radius), toCentre + Angle.FromDegrees(180), Angle.FromDegrees(radius > 0.0 ? 80 : -80)));
    }

    /// <summary>The circle touches both sides: its centre is as far from one as from the other. Found by search along the sides.</summary>
    private static Segment[] RoundedBetween(Segment[] corner, double depth)
    {
        var turn = corner[0].EndTangent.TurnTo(corner[1].StartTangent).Radians;
        var longest = depth / Math.Tan(turn / 4.0);
        var (low, high) = (0.0, 1.0);
        for (var i = 0; i < 60; i++)
        {
            var middle = (low + high) / 2.0;
            if (Circle(middle) is var (centre, radius, contact, contactSecond) && centre.DistanceTo(default) - radius <= depth && contact <= longest && contactSecond <= longest) low = middle;
            else high = middle;
        }

        var (at, size, before, after) = Circle(low)!.Value;
        var (from, to) = (corner[0].PointAt(1.0 - (before / corner[0].Length)), corner[1].PointAt(after / corner[1].Length));
        var arc = new ArcSegment(at, size, (from - at).Direction, (from - at).TurnTo(to - at));
        return [Part(corner[0], 0.0, 1.0 - (before / corner[0].Length)), Segment.FromArc(arc), Part(corner[1], after / corner[1].Length, 1.0)];

        (Point2D Centre, double Radius, double Contact, double ContactSecond)? Circle(double share)
        {
            var contact = share * Math.Min(2.0 * longest, 0.9 * corner[0].Length);
            var (place, along) = (corner[0].PointAt(1.0 - (contact / corner[0].Length)), corner[0].TangentAt(1.0 - (contact / corner[0].Length)));
            var (small, large) = (0.0, 1e4);
            for (var i = 0; i < 100; i++)
            {
                var middle = (small + large) / 2.0;
                if (corner[1].DistanceTo(Centre(middle)) >= middle) small = middle;
                else large = middle;
            }

            var foot = PerpendicularFoot.Place(corner[1], Centre(small), double.NaN).Foot;
            return (Centre(small), small, contact, foot * corner[1].Length);

            Point2D Centre(double radius) => place + (new Vector2D(-along.Y, along.X) * radius);
        }
    }

    private static Segment Part(Segment segment, double from, double to) => segment.Kind == SegmentKind.Line
        ? Segment.FromLine(segment.PointAt(from), segment.PointAt(to))
        : Segment.FromArc(segment.Arc with { Start = segment.Arc.Start + (segment.Arc.Sweep * from), Sweep = segment.Arc.Sweep * (to - from) });

    private static Segment[] Corner(double turn) => [Segment.FromLine(new Point2D(-10, 0), default), Segment.FromLine(default, default(Point2D) + Vector2D.FromPolar(10, Angle.FromDegrees(turn)))];

    /// <summary>The two lines with an arc whose largest distance from their common point is given.</summary>
    private static Segment[] Rounded(Segment[] corner, double depth)
    {
        var turn = corner[0].EndTangent.TurnTo(corner[1].StartTangent);
        var half = Math.Abs(turn.Radians) / 2.0;
        var radius = depth * Math.Cos(half) / (1.0 - Math.Cos(half));
        var (from, to) = (corner[0].End - (corner[0].EndTangent * (radius * Math.Tan(half))), corner[1].Start + (corner[1].StartTangent * (radius * Math.Tan(half))));
        var centre = from + (new Vector2D(-corner[0].EndTangent.Y, corner[0].EndTangent.X) * (radius * Math.Sign(turn.Degrees)));
        var arc = new ArcSegment(centre, radius, (from - centre).Direction, turn);
        return [Segment.FromLine(corner[0].Start, from), Segment.FromArc(arc, from, to), Segment.FromLine(to, corner[1].End)];
    }

    /// <summary>The verdicts for spans and for samples.</summary>
    private static TraceVerdict[] Both(IReadOnlyList<Segment> drawn, IReadOnlyList<Segment> path, TraceTolerances tolerances, params Segment[][] others)
    {
        var (spans, samples) = (new TraceJudge(drawn, tolerances), new TraceJudge(drawn, tolerances));
        foreach (var stroke in (IReadOnlyList<Segment>[])[path, .. others])
        {
            var off = new TraceSample(0, stroke[0].Start.X, stroke[0].Start.Y, false);
            spans.Add(off);
            samples.Add(off);
            foreach (var part in stroke.Where(part => part.Length > 0.0))
            {
                spans.Add(new TraceSpan(0, 1, 1000, part, true));
                var steps = 2 * (int)Math.Ceiling(part.Length / 0.004); // even: the middle of an arc is a sample
                for (var i = 0; i <= steps; i++) samples.Add(new TraceSample(i, part.PointAt((double)i / steps).X, part.PointAt((double)i / steps).Y, true));
            }
        }

        return [spans.Verdict(), samples.Verdict()];
    }
}
