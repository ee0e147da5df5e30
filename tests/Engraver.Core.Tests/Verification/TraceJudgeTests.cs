using Engraver.Core.Geometry;
using Engraver.Core.Verification;
using Engraver.TestKit;

namespace Engraver.Core.Tests.Verification;

/// <summary>The judge that receives samples during a run: spans of any length, exact gaps, both directions of travel.</summary>
public class TraceJudgeTests
{
    private static readonly TraceTolerances Tolerances = UsualOptions.Trace;

    public static TheoryData<Segment> Long =>
    [
        Segment.FromLine(new Point2D(0, 0), new Point2D(100_000, 0)),
        Segment.FromLine(new Point2D(-3000, 70), new Point2D(41_000, 90_000)),
        Segment.FromArc(new ArcSegment(new Point2D(5, 7), 50_000, Angle.FromDegrees(10), Angle.FromDegrees(80))),
        Segment.FromArc(new ArcSegment(new Point2D(5, 7), 50_000, Angle.FromDegrees(300), Angle.FromDegrees(-75))),
    ];

    [Theory]
    [MemberData(nameof(Long))]
    public void A_hundred_metres_in_one_span_are_whole_and_exact_in_either_direction(Segment segment)
    {
        foreach (var path in (Segment[])[segment, segment.Reversed()])
        {
            var verdict = Judged([segment], path);

            Assert.InRange(verdict.MaxDeviation, 0.0, 1e-6);
            Assert.Equal((0.0, null, 0.0), (verdict.MissingLength, verdict.MissingAt, verdict.ExtraLength));
        }
    }

    /// <summary>An arc of ten kilometres is almost a line, and its angles are as small as rounding: the ramps of its cut are samples a hundredth of a
    /// millimetre apart.</summary>
    [Theory]
    [InlineData(1e5)]
    [InlineData(1e7)]
    [InlineData(1e8)]
    public void An_arc_of_huge_radius_is_whole_where_it_was_cut_in_short_steps(double radius)
    {
        var half = Math.Asin(10.0 / radius) * 180.0 / Math.PI;
        var drawn = Segment.FromArc(new ArcSegment(new Point2D(0, -radius), radius, Angle.FromDegrees(90 - half), Angle.FromDegrees(2 * half)));
        TraceSample[] trace = [.. Enumerable.Range(0, 2001).Select(i => drawn.PointAt(i / 2000.0)).Select((place, i) => new TraceSample(i / 1000.0, Math.Round(place.X, 3), Math.Round(place.Y, 3), true))];

        var verdict = TraceComparison.Compare([drawn], trace, Tolerances);

        Assert.Equal((0.0, null), (verdict.MissingLength, verdict.MissingAt));
    }

    [Theory]
    [MemberData(nameof(Long))]
    public void A_gap_of_a_millimetre_in_a_hundred_metres_is_found(Segment segment)
    {
        var (from, to) = (0.3, 0.3 + (1.0 / segment.Length));
        var verdict = Judged([segment], Part(segment, 0.0, from), Part(segment, to, 1.0));

        Assert.InRange(verdict.MissingLength, 0.99, 1.0);
        Assert.InRange(verdict.MissingAt!.Value.DistanceTo(segment.PointAt(from)), 0.0, 0.1);
    }

    [Fact]
    public void A_line_that_leaves_the_drawn_one_deviates_by_its_far_end()
    {
        var drawn = Segment.FromLine(new Point2D(0, 0), new Point2D(100_000, 0));
        var verdict = Judged([drawn], Segment.FromLine(new Point2D(0, 0), new Point2D(100_000, 0.006)));

        Assert.Equal(0.006, verdict.MaxDeviation, 1e-4);
        Assert.InRange(verdict.ExtraLength, 32_000, 34_000);
    }

    [Fact]
    public void A_bump_in_the_drawing_under_a_long_span_is_found()
    {
        Segment[] drawn =
        [
            Segment.FromLine(new Point2D(0, 0), new Point2D(61_803, 0)),
            Segment.FromLine(new Point2D(61_803, 0), new Point2D(61_804, 1)),
            Segment.FromLine(new Point2D(61_804, 1), new Point2D(61_805, 0)),
            Segment.FromLine(new Point2D(61_805, 0), new Point2D(100_000, 0)),
        ];
        var verdict = Judged(drawn, Segment.FromLine(new Point2D(0, 0), new Point2D(100_000, 0)));

        Assert.InRange(verdict.MaxDeviation, 0.70, 0.72);
        Assert.InRange(verdict.MissingLength, 2.80, 2.83);
    }

    [Theory]
    [InlineData(298, false)]
    [InlineData(400, false)]
    [InlineData(298, true)]
    [InlineData(400, true)]
    public void Samples_along_an_arc_cover_it_in_either_direction(int steps, bool isReversed)
    {
        var arc = Segment.FromArc(new ArcSegment(new Point2D(14.4, 13.5), 1.9, Angle.FromDegrees(180), Angle.FromDegrees(180)));
        var judge = new TraceJudge([arc], Tolerances);
        for (var i = 0; i <= steps; i++)
        {
            var place = arc.PointAt((double)(isReversed ? steps - i : i) / steps);
            judge.Add(new TraceSample(i, Math.Round(place.X, 3), Math.Round(place.Y, 3), true));
        }

        Assert.Equal(0.0, judge.Verdict().MissingLength);
    }

    /// <summary>More seeds by <c>ENGRAVER_JUDGE_SEEDS=1000</c>.</summary>
    [Fact]
    public void Spans_and_the_samples_they_stand_for_are_judged_alike()
    {
        var seeds = TestExtent.Cases(perCommit: 40, full: 200, "ENGRAVER_JUDGE_SEEDS");
        for (var seed = 0; seed < seeds; seed++)
        {
            var random = new Random(seed);
            var drawn = Enumerable.Range(0, 6).Select(_ => Any(random)).ToArray();
            var paths = Enumerable.Range(0, 4).Select(_ => random.Next(2) == 0 ? Any(random) : Part(drawn[random.Next(drawn.Length)], random.NextDouble() / 2, 0.5 + (random.NextDouble() / 2))).ToArray();

            var spans = Judged(drawn, paths);
            var samples = Sampled(drawn, paths);

            Assert.Equal(samples.MaxDeviation, spans.MaxDeviation, 0.01 + (0.005 * samples.MaxDeviation));
            Assert.Equal(samples.MissingLength, spans.MissingLength, 0.4);
            Assert.Equal(samples.ExtraLength, spans.ExtraLength, 0.4);
        }
    }

    private static Segment Any(Random random)
    {
        Point2D Place() => new(random.Next(0, 40), random.Next(0, 40));
        if (random.Next(2) == 0) return Segment.FromArc(new ArcSegment(Place(), random.Next(1, 20), Angle.FromDegrees(random.Next(0, 360)), Angle.FromDegrees(random.Next(10, 90) * (random.Next(2) == 0 ? 1 : -1))));
        var start = Place();
        return Segment.FromLine(start, start + new Vector2D(random.Next(1, 30), random.Next(-30, 30)));
    }

    private static Segment Part(Segment segment, double from, double to)
    {
        if (segment.Kind == SegmentKind.Line) return Segment.FromLine(segment.PointAt(from), segment.PointAt(to));
        return Segment.FromArc(segment.Arc with { Start = segment.Arc.Start + (segment.Arc.Sweep * from), Sweep = segment.Arc.Sweep * (to - from) });
    }

    private static TraceVerdict Judged(Segment[] drawn, params Segment[] paths)
    {
        var judge = new TraceJudge(drawn, Tolerances);
        foreach (var path in paths)
        {
            judge.Add(new TraceSample(0, path.Start.X, path.Start.Y, false));
            judge.Add(new TraceSpan(0, 1, 1000, path, true));
            judge.Add(new TraceSample(1, path.End.X, path.End.Y, false));
        }

        return judge.Verdict();
    }

    private static TraceVerdict Sampled(Segment[] drawn, Segment[] paths)
    {
        const int Steps = 4000;
        var judge = new TraceJudge(drawn, Tolerances);
        foreach (var path in paths)
        {
            judge.Add(new TraceSample(0, path.Start.X, path.Start.Y, false));
            for (var i = 0; i <= Steps; i++) judge.Add(new TraceSample(i, path.PointAt((double)i / Steps).X, path.PointAt((double)i / Steps).Y, true));
            judge.Add(new TraceSample(1, path.End.X, path.End.Y, false));
        }

        return judge.Verdict();
    }
}
