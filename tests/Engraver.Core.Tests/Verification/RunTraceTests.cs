using Engraver.Core.Geometry;
using Engraver.Core.Verification;

namespace Engraver.Core.Tests.Verification;

/// <summary>The stored part of a run is bounded, and contains the point of the largest deviation.</summary>
public class RunTraceTests
{
    private static readonly Segment[] s_line = [Segment.FromLine(new(0, 0), new(1000, 0))];

    [Fact]
    public void However_long_the_run_no_more_is_kept_and_the_worst_place_is_among_it()
    {
        var builder = new RunTraceBuilder(s_line, most: 64);
        for (var i = 0; i < 10_000; i++) builder.Add(new TraceSample(i * 0.001, i * 0.1, i == 4321 ? 0.25 : 0.001, Cutting: true));
        var trace = builder.ToTrace("record");

        Assert.InRange(trace.Places.Count, 32, 65);
        Assert.Equal(new RunTracePlace(4.321, new Point2D(432.1, 0.25), true, 0.25), trace.Places.MaxBy(place => place.DeviationMm));
        Assert.Equal(trace.Places.OrderBy(place => place.Seconds), trace.Places);
        Assert.InRange(trace.Places[^1].Seconds, 9.7, 9.999);
    }

    [Fact]
    public void Deviation_is_the_distance_from_the_drawing_while_the_tool_is_on()
    {
        var builder = new RunTraceBuilder(s_line);
        builder.Add(new TraceSample(0.0, 5, 7, Cutting: false));
        builder.Add(new TraceSpan(0.1, 0.12, 21, Segment.FromLine(new(5, 0), new(7, 0.5)), Cutting: true));
        var trace = builder.ToTrace("polled");

        Assert.Equal([0.0, 0.0, 0.25, 0.5], trace.Places.Select(place => place.DeviationMm));
        Assert.Equal(Math.Sqrt(1 + 0.0625) / 0.01, trace.SpeedTo(2), 6);
        Assert.Equal(0.0, trace.SpeedTo(0));
    }

    [Fact]
    public void What_was_written_is_read_again_and_anything_else_is_refused_by_its_line()
    {
        var builder = new RunTraceBuilder(s_line);
        for (var i = 0; i < 5; i++) builder.Add(new TraceSample(i, i * 0.125, -0.5, Cutting: i > 1));
        var trace = builder.ToTrace("record");
        using var written = new StringWriter();
        trace.Write(written);

        var read = RunTrace.Read(new StringReader(written.ToString()));
        Assert.Equal(trace.Source, read.Source);
        Assert.Equal(trace.Places, read.Places);
        Assert.Contains("line 4", Assert.Throws<FormatException>(() => RunTrace.Read(new StringReader("# record\nseconds,x,y,tool,deviation\n0,0,0,1,0\n0,0,nan,1,0\n"))).Message, StringComparison.Ordinal);
        Assert.Contains("line 1", Assert.Throws<FormatException>(() => RunTrace.Read(new StringReader("t,a,b"))).Message, StringComparison.Ordinal);
    }

    [Fact]
    public void The_following_error_the_drawing_and_the_conditions_are_kept_and_traces_of_earlier_versions_are_still_read()
    {
        var builder = new RunTraceBuilder(s_line);
        builder.Conditions = new TraceConditions(1.25, 0.5);
        builder.Add(new TraceSample(0.1, 5, 0, Cutting: true) { FollowingMm = 0.125 });
        builder.Conditions = new TraceConditions(0.1, null);
        builder.Add(new TraceSample(0.2, 6, 0, Cutting: true));
        var trace = builder.ToTrace("polled");
        using var written = new StringWriter { NewLine = "\n" };
        trace.Write(written);

        Assert.StartsWith($"# polled; version 3; drawing {DrawnFingerprint.Of(s_line)}\nseconds,x,y,tool,deviation,following,feed,link\n0.1,5,0,1,0,0.125,1.25,0.5\n0.2,6,0,1,0,,0.1,\n", written.ToString(), StringComparison.Ordinal);
        var read = RunTrace.Read(new StringReader(written.ToString()));
        Assert.Equal([0.125, null], read.Places.Select(place => place.FollowingMm));
        Assert.Equal([new TraceConditions(1.25, 0.5), new TraceConditions(0.1, null)], read.Places.Select(place => place.Conditions));
        Assert.True(read.HasFollowing && read.CanBeOf(DrawnFingerprint.Of(s_line)));
        Assert.False(read.CanBeOf(DrawnFingerprint.Of([Segment.FromLine(new(0, 0), new(1000, 0.001))])));

        var second = RunTrace.Read(new StringReader("# polled; version 2; drawing ab\nseconds,x,y,tool,deviation,following\n0.5,1,2,1,0.25,0.125\n"));
        Assert.Equal(new RunTracePlace(0.5, new Point2D(1, 2), true, 0.25, 0.125), Assert.Single(second.Places));
        var first = RunTrace.Read(new StringReader("# record\nseconds,x,y,tool,deviation\n0.5,1,2,1,0.25\n"));
        Assert.Equal(("record", new RunTracePlace(0.5, new Point2D(1, 2), true, 0.25)), (first.Source, Assert.Single(first.Places)));
        Assert.False(first.HasFollowing);
        Assert.True(first.CanBeOf("anything"));
    }

    [Theory]
    [InlineData("# record; version 4; drawing ab\nseconds,x,y,tool,deviation,following,feed,link\n", "version is 4")]
    [InlineData("# record; version 3; drawing ab\nseconds,x,y,tool,deviation,following\n", "line 2")]
    [InlineData("# record; version 2; drawing ab\nseconds,x,y,tool,deviation\n", "line 2")]
    [InlineData("# record; version two\nseconds,x,y,tool,deviation,following\n", "line 1")]
    [InlineData("# record; version 2; drawing ab\nseconds,x,y,tool,deviation,following\n0,0,0,1,0\n", "line 3")]
    [InlineData("# record; version 2; drawing ab\nseconds,x,y,tool,deviation,following\n0,0,0,1,0,x\n", "line 3")]
    public void A_trace_of_another_make_is_refused_with_what_is_wrong(string text, string said) =>
        Assert.Contains(said, Assert.Throws<FormatException>(() => RunTrace.Read(new StringReader(text))).Message, StringComparison.Ordinal);

    [Fact]
    public void The_largest_following_error_is_not_thinned_out()
    {
        var builder = new RunTraceBuilder(s_line, most: 64);
        for (var i = 0; i < 10_000; i++) builder.Add(new TraceSample(i * 0.001, i * 0.1, 0.001, Cutting: true) { FollowingMm = i == 5432 ? 0.75 : 0.01 });

        var places = builder.ToTrace("record").Places;
        Assert.Equal(0.75, places.Max(place => place.FollowingMm));
        Assert.Equal(1, places.Count(place => place.FollowingMm > 0.02));
        Assert.InRange(places.Single(place => place.FollowingMm > 0.02).Seconds, 5.0, 6.0);
    }
}
