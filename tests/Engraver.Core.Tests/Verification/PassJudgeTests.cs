using Engraver.Core.Geometry;
using Engraver.Core.Sequencing;
using Engraver.Core.Verification;

namespace Engraver.Core.Tests.Verification;

/// <summary>A line of 10 mm that is cut 1 mm deep, then 2 mm, then 2 mm again; and another beside it, 1 mm deep: passes 0 to 3.</summary>
public class PassJudgeTests
{
    private const double Up = 5.0;
    private const double MillimetresPerSecond = 10.0;

    private static readonly TraceTolerances s_tolerances = new() { Count = 0.001, MaxError = 0.001 };

    private double _seconds;

    [Fact]
    public void Every_pass_has_its_own_figures()
    {
        var judge = NewJudge();
        foreach (var (y, z) in ((double, double)[])[(0, -1), (0, -2), (0, -2), (1, -1)]) Cut(judge, 0, 10, y, z);

        Assert.Equal([1.0, 2.0, 2.0, 1.0], judge.Measured().Select(pass => pass!.Depth));
        Assert.All(judge.Measured(), pass => Assert.Equal((0.0, 0.0, 0.0), (Math.Round(pass!.MaxDeviation, 9), pass.MissingLength, pass.ExtraLength)));
        Assert.All(judge.Measured(), pass => Assert.Equal(600.0, pass!.FeedMmPerMinute!.Value, 6));
    }

    /// <summary>The whole drawing is cut in both cases, so that a judge of all rows finds nothing.</summary>
    [Fact]
    public void A_repeat_that_is_left_out_and_a_pass_at_the_depth_of_another_are_found()
    {
        var judge = NewJudge();
        foreach (var (y, z) in ((double, double)[])[(0, -1), (0, -2), (1, -1)]) Cut(judge, 0, 10, y, z);
        Assert.Equal([false, false, true, false], judge.Measured().Select(pass => pass is null));
        Assert.Equal(10.0, judge.Verdict().MissingLength, 6);

        judge = NewJudge();
        foreach (var (y, z) in ((double, double)[])[(0, -2), (0, -1), (0, -2), (1, -1)]) Cut(judge, 0, 10, y, z);
        Assert.Equal([1.0, 1.0, 0.0, 0.0], judge.Measured().Select(pass => Math.Round(pass!.MaxDeviation, 6)));
    }

    [Fact]
    public void A_hold_within_a_stroke_and_a_run_that_resumes_it_do_not_start_the_next()
    {
        var judge = NewJudge();
        Cut(judge, 0, 4, 0, -1);
        Cut(judge, 4, 10, 0, -1);
        Cut(judge, 0, 6, 0, -2);
        judge.BeginRun();
        Cut(judge, 5, 10, 0, -2);
        foreach (var (y, z) in ((double, double)[])[(0, -2), (1, -1)]) Cut(judge, 0, 10, y, z);

        Assert.Equal([null, 2.0, 2.0, 1.0], judge.Measured().Select(pass => pass?.Depth));
        Assert.Equal(0.0, judge.Verdict().MissingLength);
        Assert.Equal(0.0, judge.Verdict().MaxDeviation, 9);
    }

    private static PassJudge NewJudge() => new(
        [Line(0, 0, -1), Line(1, 0, -2), Line(2, 0, -2), Line(3, 1, -1)],
        moves => new HeightJudge(moves, 0.0, null, s_tolerances),
        near: 0.02);

    private static JudgedStroke Line(int pass, double y, double z) => new(pass, [new StrokeMove(Segment.FromLine(new Point2D(0, y), new Point2D(10, y)), 0, z, z)]);

    /// <summary>Down, along the line, and up, a sample each millisecond.</summary>
    private void Cut(PassJudge judge, double from, double to, double y, double z)
    {
        judge.Add(new TraceSample(_seconds += 0.001, from, y, false, Up));
        judge.Add(new TraceSample(_seconds += 0.001, from, y, true, z / 2.0));
        for (var step = 0; step <= (to - from) * 100.0; step++) judge.Add(new TraceSample(_seconds += 0.01 / MillimetresPerSecond, from + (step / 100.0), y, true, z));
        judge.Add(new TraceSample(_seconds += 0.001, to, y, false, Up));
    }
}
