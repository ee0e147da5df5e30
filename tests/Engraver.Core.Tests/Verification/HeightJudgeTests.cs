using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Sequencing;
using Engraver.Core.Verification;
using Engraver.TestKit;

namespace Engraver.Core.Tests.Verification;

/// <summary>The motion of a machine with a tool axis, compared with a drawing in three coordinates.</summary>
public class HeightJudgeTests
{
    private static readonly HeightDrive s_drive = new() { CutDepth = 0.0 };
    private static readonly StrokeMove s_ramp = new(Segment.FromLine(new Point2D(0, 0), new Point2D(10, 0)), 0, -1.0, -3.0);

    [Fact]
    public void A_ramp_that_is_followed_is_whole_and_true()
    {
        var found = Judge([s_ramp], s_drive, Down(0, -1.0), Along(i => (0.01 * i, 0.0, -1.0 - (0.002 * i)), 1000), Up(10, -3.0));

        Assert.InRange(found.MaxDeviation, 0.0, 1e-9);
        Assert.Equal((0.0, 0.0), (found.MissingLength, found.ExtraLength));
        Assert.InRange(found.CuttingSamples, 1000, 1100);
    }

    [Theory]
    [InlineData(0.02)]
    [InlineData(-0.02)]
    public void A_path_that_is_right_in_plan_and_wrong_in_height_is_as_far_off_as_it_is_too_high_or_too_deep(double off)
    {
        var found = Judge([s_ramp], s_drive, Along(i => (0.01 * i, 0.0, -1.0 - (0.002 * i) + off), 1000));

        Assert.InRange(found.MaxDeviation, 0.0196, 0.0200001); // across the ramp, and straight up from its end
        Assert.InRange(found.MissingLength, 9.9, 10.0001);
        Assert.InRange(found.ExtraLength, 9.9, 10.3);
    }

    [Fact]
    public void What_lies_at_another_depth_in_the_same_place_is_missing_until_it_is_cut_itself()
    {
        StrokeMove[] drawing = [Level(-1.0), Level(-2.0)];

        var upper = Judge(drawing, s_drive, Along(i => (0.01 * i, 0.0, -1.0), 1000));
        var both = Judge(drawing, s_drive, Along(i => (0.01 * i, 0.0, -1.0), 1000), Up(10, -1.0), Down(0, -2.0), Along(i => (0.01 * i, 0.0, -2.0), 1000));

        Assert.Equal((0.0, 10.0), (Math.Round(upper.MaxDeviation, 9), Math.Round(upper.MissingLength, 3)));
        Assert.Equal((0.0, 0.0), (Math.Round(both.MaxDeviation, 9), both.MissingLength));
    }

    [Fact]
    public void A_drawn_line_that_lies_on_another_is_cut_with_it() =>
        Assert.Equal(0.0, Judge([Level(-1.0), Level(-1.0)], s_drive, Along(i => (0.01 * i, 0.0, -1.0), 1000)).MissingLength);

    [Fact]
    public void An_earlier_pass_is_right_a_whole_step_higher_and_cuts_nothing_to_its_depth()
    {
        var passes = s_drive with { CutDepth = 2.0, DepthPerPass = 0.8 };

        var first = Judge([Level(0.0)], passes, Along(i => (0.01 * i, 0.0, -1.2), 1000));
        var between = Judge([Level(0.0)], passes, Along(i => (0.01 * i, 0.0, -1.5), 1000));
        var whole = Judge([Level(0.0)], passes, Along(i => (0.01 * i, 0.0, -1.2), 1000), Along(i => (10 - (0.01 * i), 0.0, -2.0), 1000));

        Assert.Equal((0.0, 10.0), (Math.Round(first.MaxDeviation, 9), Math.Round(first.MissingLength, 3)));
        Assert.Equal(0.3, between.MaxDeviation, 6);
        Assert.Equal((0.0, 0.0), (Math.Round(whole.MaxDeviation, 9), whole.MissingLength));
    }

    [Fact]
    public void Straight_down_the_tool_may_be_at_any_height_over_the_work_and_not_below_it()
    {
        Assert.Equal(0.0, Judge([Level(-2.0)], s_drive, Down(3, -2.0), Up(3, -2.0)).MaxDeviation);
        Assert.Equal(0.5, Judge([Level(-2.0)], s_drive, Down(3, -2.5), Up(3, -2.5)).MaxDeviation, 6);
        Assert.Equal(2.0, Judge([Level(-2.0)], s_drive, [.. Down(3, -2.0).Select(sample => sample with { YMm = 2.0 })]).MaxDeviation, 6); // beside the drawing
    }

    [Fact]
    public void A_tool_that_is_found_on_the_work_or_in_it_is_taken_out_first_and_that_cuts_nothing()
    {
        TraceSample[] found = [new(0, 50, 50, true, 0.0), new(0.001, 50, 50, true, 0.5), new(0.002, 50, 50, false, 2.0)];

        Assert.Equal(0, Judge([Level(-1.0)], s_drive, found).CuttingSamples);
        Assert.InRange(Judge([Level(-1.0)], s_drive, [.. found.Take(2), new(0.002, 49, 50, true, 0.5)]).MaxDeviation, 50.0, 80.0); // dragged along before it was up
    }

    /// <summary>Sides of 28.6 um on a machine that counts in 1 um: neighbours are within the tolerance of each of them. Distinguished by their corners, and by
    /// samples 6 um apart.</summary>
    [Theory]
    [InlineData(1)]
    [InlineData(5)]
    public void A_square_little_larger_than_what_is_allowed_is_cut_whole(int steps)
    {
        Point2D[] corners = [new(0, 0), new(0.0286, 0), new(0.0286, 0.0286), new(0, 0.0286), new(0, 0)];
        StrokeMove[] square = [.. corners.Zip(corners.Skip(1), (from, to) => new StrokeMove(Segment.FromLine(from, to), 0, -1.0, -1.0))];
        TraceSample[] Cut(int sides) => [new TraceSample(-1, 0, 0, false, 2.0), .. Enumerable.Range(0, (sides * steps) + 1).Select(i => corners[i / steps].X + ((corners[Math.Min(4, (i / steps) + 1)].X - corners[i / steps].X) * (i % steps) / steps) is var x && corners[i / steps].Y + ((corners[Math.Min(4, (i / steps) + 1)].Y - corners[i / steps].Y) * (i % steps) / steps) is var y ? new TraceSample(i, Math.Round(x, 3), Math.Round(y, 3), true, -1.0) : default)];

        Assert.Equal(0.0, Judge(square, s_drive, Cut(4)).MissingLength);
        Assert.InRange(Judge(square, s_drive, Cut(2)).MissingLength, 0.02, 0.0572);
    }

    [Fact]
    public void A_hole_that_is_not_drilled_or_not_to_its_depth_is_missing_by_its_height()
    {
        var (near, far) = (new StrokeMove(Segment.FromLine(new Point2D(0, 0), new Point2D(0, 0)), 0, 0.0, -3.0), new StrokeMove(Segment.FromLine(new Point2D(10, 0), new Point2D(10, 0)), 1, 0.0, -3.0));

        Assert.Equal((0.0, 0.0), (Judge([near, far], s_drive, Down(0, -3.0), Up(0, -3.0), Down(10, -3.0), Up(10, -3.0)).MissingLength, Judge([near, far], s_drive, Down(0, -3.0), Up(0, -3.0), Down(10, -3.0), Up(10, -3.0)).ExtraLength));
        Assert.Equal(3.0, Judge([near, far], s_drive, Down(0, -3.0), Up(0, -3.0)).MissingLength, 9);
        Assert.Equal(1.0, Judge([near, far], s_drive, Down(0, -3.0), Up(0, -3.0), Down(10, -2.0), Up(10, -2.0)).MissingLength, 1);
    }

    [Fact]
    public void The_sides_of_a_tab_are_cut_where_the_tool_moves_over_it_and_missing_where_it_does_not()
    {
        StrokeMove At(double from, double to, double start, double end) => new(Segment.FromLine(new Point2D(from, 0), new Point2D(to, 0)), 0, start, end);
        StrokeMove[] path = [At(0, 4, -2, -2), At(4, 4, -2, -1), At(4, 6, -1, -1), At(6, 6, -1, -2), At(6, 10, -2, -2)];
        TraceSample[] Over(double from, double to, double z) => [.. Enumerable.Range(0, 101).Select(i => new TraceSample(i, from + ((to - from) * i / 100), 0, true, z))];
        TraceSample[] Rise(double x, double from, double to) => [.. Enumerable.Range(0, 101).Select(i => new TraceSample(i, x, 0, true, from + ((to - from) * i / 100)))];

        var whole = Judge(path, s_drive, Down(0, -2), Over(0, 4, -2), Rise(4, -2, -1), Over(4, 6, -1), Rise(6, -1, -2), Over(6, 10, -2), Up(10, -2));
        Assert.Equal((0.0, 0.0, 0.0), (Math.Round(whole.MaxDeviation, 9), whole.MissingLength, whole.ExtraLength));
        Assert.Equal(4.0, Judge(path, s_drive, Down(0, -2), Over(0, 10, -2), Up(10, -2)).MissingLength, 1);
    }

    private static StrokeMove Level(double height) => new(Segment.FromLine(new Point2D(0, 0), new Point2D(10, 0)), 0, height, height);

    private static TraceSample[] Along(Func<int, (double X, double Y, double Z)> place, int steps) => [.. Enumerable.Range(0, steps + 1).Select(i => place(i) is var (x, y, z) ? new TraceSample(i, x, y, z < 1.0, z) : default)];

    private static TraceSample[] Down(double x, double to) => [.. Enumerable.Range(0, 51).Select(i => 2.0 + ((to - 2.0) * i / 50)).Select(z => new TraceSample(0, x, 0, z < 1.0, z))];

    private static TraceSample[] Up(double x, double from) => [.. Down(x, from).Reverse()];

    private static TraceVerdict Judge(StrokeMove[] drawing, HeightDrive drive, params TraceSample[][] trace)
    {
        var judge = new HeightJudge(drawing, drive.CutDepth, drive.DepthPerPass, UsualOptions.Trace);
        foreach (var sample in trace.SelectMany(part => part)) judge.Add(sample);
        return judge.Verdict();
    }
}
