using Engraver.Core.Geometry;
using Engraver.Core.Verification;
using Engraver.TestKit;
using FsCheck;
using FsCheck.Fluent;
using FsCheck.Xunit;

namespace Engraver.Core.Tests.Verification;

public class TraceComparisonTests
{
    private static readonly Segment Line = Segment.FromLine(new Point2D(0, 0), new Point2D(10, 0));
    private static readonly Segment Arc = Segment.FromArc(new ArcSegment(new Point2D(10, 5), 5, Angle.FromDegrees(-90), Angle.FromDegrees(180)));
    private static readonly Segment Circle = Segment.FromArc(new ArcSegment(new Point2D(40, 0), 3, Angle.Zero, Angle.FullTurn));
    private static readonly Segment[] Drawing = [Line, Arc, Circle];

    /// <summary>For tests without missing length.</summary>
    private static readonly TraceTolerances Coarse = UsualOptions.Trace with { LargestStep = 100.0, MinSteps = 1 };

    [Fact]
    public void An_exact_trace_deviates_by_nothing_and_misses_nothing()
    {
        var verdict = Compare(Drawing, Trace([Line, Arc], [Circle]));

        Assert.InRange(verdict.MaxDeviation, 0.0, 1e-12);
        Assert.Equal((0.0, null, 0.0), (verdict.MissingLength, verdict.MissingAt, verdict.ExtraLength));
    }

    [Fact]
    public void One_sample_five_counts_off_is_noticed_where_it_is()
    {
        var trace = Trace([Line, Arc], [Circle]);
        var moved = trace.FindIndex(sample => sample.XMm is > 4.99 and < 5.01 && sample.YMm == 0.0);
        trace[moved] = trace[moved] with { YMm = -0.005 };

        var verdict = Compare(Drawing, trace);

        Assert.Equal(0.005, verdict.MaxDeviation, 12);
        Assert.Equal(trace[moved], verdict.DeviationAt);
    }

    [Fact]
    public void A_stroke_left_out_is_missing_with_its_length()
    {
        var verdict = Compare(Drawing, Trace([Line, Arc]));

        Assert.Equal(Circle.Length, verdict.MissingLength, 9);
        Assert.Equal(3.0, verdict.MissingAt!.Value.DistanceTo(new Point2D(40, 0)), 9);
    }

    [Fact]
    public void Part_of_a_line_left_out_is_missing_to_a_step()
    {
        var verdict = Compare([Line], Trace([Segment.FromLine(new Point2D(0, 0), new Point2D(7, 0))]));

        Assert.InRange(verdict.MissingLength, 2.94, 3.06);
    }

    [Fact]
    public void A_rapid_with_the_tool_on_is_noticed()
    {
        var between = Segment.FromLine(Arc.End, Circle.Start);

        var verdict = Compare(Drawing, Trace([Line, Arc, between, Circle]));

        Assert.InRange(verdict.MaxDeviation, 5.0, 20.0);
        Assert.InRange(verdict.ExtraLength, 20.0, between.Length);
    }

    [Fact]
    public void Travel_between_two_cuts_covers_nothing()
    {
        Segment[] ends = [Segment.FromLine(new Point2D(0, 0), new Point2D(1, 0)), Segment.FromLine(new Point2D(9, 0), new Point2D(10, 0))];

        var verdict = Compare([Line], Trace([ends[0]], [ends[1]]));

        Assert.InRange(verdict.MissingLength, 7.9, 8.1);
    }

    [Fact]
    public void The_jump_from_a_sample_with_the_tool_off_covers_nothing()
    {
        List<TraceSample> trace = [new(0, 0, 0, false), new(1, 9, 0, true), new(2, 10, 0, true)];

        Assert.InRange(Compare([Line], trace).MissingLength, 8.9, 9.1);
    }

    [Fact]
    public void A_gap_between_samples_is_covered_by_the_chord_between_them()
    {
        List<TraceSample> trace = [new(0, 0, 0, true), new(1, 10, 0, true)];

        Assert.Equal(0.0, Compare([Line], trace).MissingLength);
    }

    [Fact]
    public void Without_a_cut_everything_is_missing_and_nothing_deviates()
    {
        var verdict = Compare(Drawing, []);

        Assert.Equal((0, 0.0, null), (verdict.CuttingSamples, verdict.MaxDeviation, verdict.DeviationAt));
        Assert.Equal(Drawing.Sum(segment => segment.Length), verdict.MissingLength, 9);
    }

    [Fact]
    public void Cutting_where_nothing_is_drawn_deviates_without_limit() =>
        Assert.Equal(double.PositiveInfinity, Compare([], [new TraceSample(0, 1, 1, true)]).MaxDeviation);

    [Property]
    public Property The_deviation_is_the_one_that_looking_at_every_segment_would_find() =>
        Prop.ForAll(LoosePolylines.Any, Gen.Choose(0, int.MaxValue).ToArbitrary(), (loose, seed) =>
        {
            var random = new Random(seed);
            var trace = Enumerable.Range(0, 50).Select(i => new TraceSample(i, random.NextDouble() * 400, random.NextDouble() * 300, true)).ToList();
            var expected = trace.Max(sample => loose.Shuffled.Min(segment => segment.DistanceTo(sample.Place)));
            return TraceComparison.Compare(loose.Shuffled, trace, Coarse).MaxDeviation == expected;
        });

    [Property(MaxTest = 10)]
    public Property A_drawing_traced_along_its_contours_is_complete_in_any_order() =>
        Prop.ForAll(LoosePolylines.Any, loose =>
        {
            var verdict = Compare(loose.Shuffled, Trace([.. loose.Polylines]));
            return verdict.MaxDeviation < 1e-9 && verdict.MissingLength == 0.0;
        });

    private static TraceVerdict Compare(IReadOnlyList<Segment> drawing, IReadOnlyList<TraceSample> trace) =>
        TraceComparison.Compare(drawing, trace, UsualOptions.Trace);

    /// <summary>Samples every 0.06 mm along each stroke, tool off between strokes.</summary>
    private static List<TraceSample> Trace(params IReadOnlyList<Segment>[] strokes)
    {
        var samples = new List<TraceSample>();
        void Add(Point2D place, bool cutting) => samples.Add(new TraceSample(samples.Count * 0.001, place.X, place.Y, cutting));
        foreach (var stroke in strokes)
        {
            Add(stroke[0].Start, cutting: false);
            foreach (var segment in stroke)
            {
                var steps = Math.Max(1, (int)(segment.Length / 0.06));
                for (var i = 0; i <= steps; i++) Add(segment.PointAt((double)i / steps), cutting: true);
            }

            Add(stroke[^1].End, cutting: false);
        }

        return samples;
    }
}
