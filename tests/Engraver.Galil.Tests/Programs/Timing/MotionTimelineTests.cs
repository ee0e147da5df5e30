using Engraver.Core.Machines;
using Engraver.Core.Motion;
using Engraver.Galil.Programs.Generation;
using Engraver.Galil.Programs.Timing;

namespace Engraver.Galil.Tests.Programs.Timing;

public class MotionTimelineTests
{
    [Theory]
    [InlineData(MotionStyle.Continuous)]
    [InlineData(MotionStyle.Calls)]
    public void It_takes_as_long_as_the_estimate_and_as_much_of_each_kind(MotionStyle style)
    {
        foreach (var path in new[] { Toolpaths.Paper, Toolpaths.OfStrokes([Toolpaths.Line(1, 1, 1.2, 1)], [Toolpaths.Arc(30, 5, 4, 0, 360)], [Toolpaths.Line(30, 5, 90, 5), Toolpaths.Line(90, 5, 90, 60)]) })
        {
            var program = MotionProgramGenerator.Generate(path, MachineProfile.Default, new(0.001, 0.0), null, style).Program!;
            var timeline = MotionTimeline.From(program, DmcTimes.Ethernet, CancellationToken.None);
            var times = MotionTime.Calculate(program, DmcTimes.Ethernet);

            Assert.Equal(MotionTime.Calculate(program, DmcTimes.Ethernet).Total, timeline.Seconds, precision: 9);
            Assert.Equal(times.Cutting, Sum(timeline, MotionSpanKind.Cut), precision: 9);
            Assert.Equal(times.Rapid, Sum(timeline, MotionSpanKind.Rapid), precision: 9);
            Assert.Equal(times.Dwell, Sum(timeline, MotionSpanKind.Dwell), precision: 9);
        }
    }

    [Fact]
    public void Spans_follow_each_other_without_a_gap_in_time_or_place_and_the_tool_is_on_only_in_a_stroke()
    {
        var program = MotionProgramGenerator.Generate(Toolpaths.OfStrokes([Toolpaths.Line(1, 1, 9, 1)], [Toolpaths.Line(20, 20, 30, 20), Toolpaths.Line(30, 20, 30, 30)]), MachineProfile.Default, new(0.001, 0.0), null).Program!;
        var spans = MotionTimeline.From(program, DmcTimes.Ethernet, CancellationToken.None).Spans;

        for (var i = 1; i < spans.Count; i++)
        {
            Assert.Equal(spans[i - 1].End, spans[i].Start, precision: 12);
            Assert.Equal(spans[i - 1].To, spans[i].From);
        }

        Assert.All(spans, span => Assert.Equal(span.Kind == MotionSpanKind.Cut, span.ToolOn && span.From != span.To));
        Assert.Equal([false, false, false, true, true, false], spans.Where(span => span.Stroke == 0).Select(span => span.ToolOn));
    }

    [Fact]
    public void A_moment_is_found_in_its_span()
    {
        var timeline = MotionTimeline.From(MotionProgramGenerator.Generate(Toolpaths.Paper, MachineProfile.Default, new(0.001, 0.0), null).Program!, DmcTimes.Ethernet, CancellationToken.None);
        for (var i = 0; i < timeline.Spans.Count; i++) Assert.Equal(i, timeline.SpanAt(timeline.Spans[i].Start + (timeline.Spans[i].Seconds / 2.0)));

        Assert.Equal((0, timeline.Spans.Count - 1), (timeline.SpanAt(-1.0), timeline.SpanAt(1e9)));
        Assert.Equal(-1, MotionTimeline.From(new MotionProgram(MachineProfile.Default, default, []), DmcTimes.Ethernet, CancellationToken.None).SpanAt(0.0));
    }

    [Theory]
    [InlineData(100_000.0)]
    [InlineData(500.0)]
    public void Distance_and_time_of_a_ramp_are_each_others_inverse(double distance)
    {
        var profile = new SpeedTrapezoid(distance, 20_000, 256_000);
        Assert.Equal(SpeedTrapezoid.Time(distance, 20_000, 256_000), profile.Seconds, precision: 12);
        for (var i = 0; i <= 20; i++)
        {
            var way = distance * i / 20.0;
            Assert.Equal(way, profile.DistanceAt(profile.TimeAt(way)), precision: 6);
        }

        Assert.Equal(Math.Min(20_000, Math.Sqrt(distance * 256_000)), profile.SpeedAt(profile.Seconds / 2.0), precision: 6);
        Assert.Equal((0.0, 0.0), (profile.SpeedAt(-1), profile.SpeedAt(1e6)));
    }

    private static double Sum(MotionTimeline timeline, MotionSpanKind kind) => timeline.Spans.Where(span => span.Kind == kind).Sum(span => span.Seconds);
}
