using Engraver.Core.Machines;
using Engraver.Galil.Jobs.Watching;

namespace Engraver.Galil.Tests.Jobs.Watching;

/// <summary>Distinguishes a polled position that is off the path from one that was only read at two times.</summary>
public class PathWatchTests
{
    /// <summary>20 counts a sample.</summary>
    private const int Speed = 20000;

    private static PathWatch Level => new(new(0, 0), [MotionPrograms.Line(10000, 0, 4, 10000)], Speed, 0.001);

    private static PathWatch Slanting => new(new(0, 0), [MotionPrograms.Line(10000, 10000, 4, 14142)], Speed, 0.001);

    [Theory]
    [InlineData(5000, 0)]
    [InlineData(5000, 2)]
    [InlineData(0, 0)]
    [InlineData(10000, 0)]
    public void On_the_path_or_within_the_rounding_is_right(int x, int y) => Assert.Null(Level.Check(0, new(x, y)));

    [Fact]
    public void Along_an_axis_two_readings_at_different_times_lie_on_the_path_so_that_three_counts_are_off()
    {
        var end = Level.Check(0, new(5000, 3))!;

        Assert.Equal(JobOutcome.Deviated, end.Outcome);
        Assert.Equal("The machine was at 5000,3 of the drawing (counts), 3 counts off the planned path, at drawing entity 4: a command was corrupted, or another program moves the axes. Check the workpiece, the cable and what else uses the controller.", end.Sentence);
    }

    /// <summary>14 counts of each axis in a sample: 10 beside the path if one axis is read a sample later.</summary>
    [Fact]
    public void On_a_slanting_line_what_a_sample_between_the_readings_explains_is_off_only_when_it_comes_again_and_again()
    {
        var seldom = Slanting;
        for (var i = 0; i < 100; i++)
        {
            Assert.Null(seldom.Check(0, new(3000 + i, 3014 + i)));
            Assert.Null(seldom.Check(0, new(3000 + i, 3000 + i)));
        }

        var always = Slanting;
        for (var i = 0; i < 7; i++) Assert.Null(always.Check(0, new(3000 + i, 3014 + i)));
        Assert.Equal(JobOutcome.Deviated, always.Check(0, new(3007, 3021))!.Outcome);
        Assert.Equal(JobOutcome.Deviated, Slanting.Check(0, new(3000, 3020))!.Outcome);
    }

    [Fact]
    public void A_turn_that_ends_early_is_off_at_its_end_and_one_of_another_radius_on_its_way()
    {
        var paper = MotionPrograms.Paper.Strokes[0].Sequences[1];
        var watch = new PathWatch(paper.Start, paper.Segments, Speed, 0.001);

        Assert.Null(watch.Check(1, new(10000, 20000)));
        Assert.Equal(JobOutcome.Deviated, watch.Check(1, new(10000, 20030))!.Outcome);
        Assert.Null(watch.LookAtEnd(new(5000, 5000)));
        Assert.Equal(JobOutcome.Deviated, watch.LookAtEnd(new(5000, 5003))!.Outcome);
    }

    [Fact]
    public void The_position_may_be_some_short_segments_ahead_of_the_counter()
    {
        var row = MotionPrograms.ShortLines(100, step: 60).Strokes[0].Sequences[0];
        var watch = new PathWatch(row.Start, row.Segments, Speed, 0.001);

        Assert.Null(watch.Check(10, new(13 * 60, 1)));
        Assert.Equal(JobOutcome.Deviated, watch.Check(10, new(40 * 60, 0))!.Outcome);
    }
}
