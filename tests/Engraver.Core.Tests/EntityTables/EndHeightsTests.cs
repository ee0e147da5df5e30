using Engraver.Core.EntityTables;
using Engraver.Core.Geometry;

namespace Engraver.Core.Tests.EntityTables;

/// <summary>A level is at most as high as the tolerance, noise does not end a level, and a drawing at one level is flat.</summary>
public class EndHeightsTests
{
    private const double Tolerance = 0.05;

    /// <summary>Steps of a fifth of the tolerance over forty of them: every level is at most as high as the tolerance, and neighbours are
    /// distinguished.</summary>
    [Fact]
    public void The_small_steps_of_a_ramp_do_not_make_one_level_of_all_depths()
    {
        double[] heights = [.. Enumerable.Range(0, 200).Select(step => -0.01 * step)];
        var levels = LevelsOf(heights, out var found);

        foreach (var level in levels.Zip(heights).GroupBy(end => end.First, end => end.Second)) Assert.InRange(level.Max() - level.Min(), 0.0, Tolerance + 1e-12);
        Assert.False(found.AreFlat);
        Assert.InRange(levels.Distinct().Count(), 2.0 / (Tolerance + 0.01), 2.0 / Tolerance);
        Assert.Equal(levels.OrderDescending(), levels); // downwards, as the heights go
        Assert.Equal(0, levels[^1]);
    }

    [Theory]
    [InlineData(new[] { 0.0, 0.05, 0.3 }, new[] { 0, 0, 1 })] // the tolerance itself is still one level
    [InlineData(new[] { 0.0, 0.0502, 0.3 }, new[] { 0, 1, 2 })]
    [InlineData(new[] { 0.0, 0.03, 0.06, 0.3 }, new[] { 0, 0, 1, 2 })] // counted from the lowest of a level, not from neighbour to neighbour
    [InlineData(new[] { 0.0, 0.05, 0.0500000001, 0.3 }, new[] { 0, 0, 0, 1 })] // noise does not end a level
    [InlineData(new[] { 0.3, -1.0, 0.0, -1.0000000001 }, new[] { 2, 0, 1, 0 })] // in any order of drawing
    public void Heights_within_the_tolerance_are_one_level(double[] heights, int[] expected)
    {
        Assert.Equal(expected, LevelsOf(heights, out var found));
        Assert.Equal(heights, Enumerable.Range(0, heights.Length).Select(row => found.HeightOf(2 * row)));
    }

    [Theory]
    [InlineData(0.0, 0.0, 0.0)]
    [InlineData(-2.5, -2.5, -2.5000000001)]
    [InlineData(7.0, 7.05, 7.02)]
    public void A_drawing_at_one_level_is_flat_at_any_height(double a, double b, double c)
    {
        Assert.Equal([0, 0, 0], LevelsOf([a, b, c], out var found));
        Assert.True(found.AreFlat);
        Assert.Equal(0.0, found.HeightOf(0));
    }

    /// <summary>A tolerance of 0 applies to the plan.</summary>
    [Theory]
    [InlineData(0.0, 0.01)]
    [InlineData(0.2, 0.2)]
    public void The_tolerance_is_never_below_a_hundredth(double join, double expected) => Assert.Equal(expected, EndHeights.ToleranceFor(join));

    /// <summary>The ends of a line that rises are two ends.</summary>
    [Fact]
    public void Both_ends_of_a_line_have_their_own_level()
    {
        var table = new EntityTable();
        table.Append(Line(-1.0, 0.0), 0, null);
        var found = EndHeights.From(table, Tolerance);

        Assert.Equal((0, 1, -1.0, 0.0), (found.LevelOf(0), found.LevelOf(1), found.HeightOf(0), found.HeightOf(1)));
    }

    private static int[] LevelsOf(double[] heights, out EndHeights found)
    {
        var table = new EntityTable();
        foreach (var height in heights) table.Append(Line(height, height), 0, null);
        var ends = found = EndHeights.From(table, Tolerance);
        for (var row = 0; row < heights.Length; row++) Assert.Equal(ends.LevelOf(2 * row), ends.LevelOf((2 * row) + 1));
        return [.. Enumerable.Range(0, heights.Length).Select(row => ends.LevelOf(2 * row))];
    }

    private static EntitySlots Line(double startZ, double endZ)
    {
        var slots = default(EntitySlots);
        slots[EntitySlot.Kind] = (int)SegmentKind.Line;
        slots.SetStart(new Point2D(0, 0), startZ);
        slots.SetEnd(new Point2D(1, 0), endZ);
        return slots;
    }
}
