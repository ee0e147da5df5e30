using Engraver.App.Plots;
using Engraver.App.Texts;
using ScottPlot;

namespace Engraver.App.Tests.Plots;

public sealed class TimeTicksTests
{
    [Theory]
    [InlineData(0.0, 49.0, 350.0, 10.0, "00:00", "00:40")]
    [InlineData(0.0, 5400.0, 700.0, 600.0, "00:00", "1:30:00")]
    [InlineData(12.31, 12.34, 700.0, 0.005, "00:12.310", "00:12.340")]
    [InlineData(7205.0, 7207.0, 350.0, 0.5, "2:00:05.0", "2:00:07.0")]
    public void Ticks_are_at_steps_of_a_clock_with_as_many_decimals_as_they_need(double start, double end, double pixels, double step, string first, string last)
    {
        var ticks = new TimeTicks();
        using var paint = Paint.NewDisposablePaint();

        ticks.Regenerate(new CoordinateRange(start, end), Edge.Bottom, new PixelLength((float)pixels), paint, new LabelStyle { FontSize = PlotPicture.FontSize });

        Assert.Equal((first, last), (ticks.Ticks[0].Label, ticks.Ticks[^1].Label));
        Assert.Equal(step, ticks.Ticks[1].Position - ticks.Ticks[0].Position, 9);
    }

    [Fact]
    public void A_range_without_length_has_no_ticks()
    {
        var ticks = new TimeTicks();
        using var paint = Paint.NewDisposablePaint();
        ticks.Regenerate(new CoordinateRange(5, 5), Edge.Bottom, new PixelLength(100.0f), paint, new LabelStyle());
        Assert.Empty(ticks.Ticks);
    }

    [Theory]
    [InlineData(41.25, 1, "00:41.3")]
    [InlineData(59.96, 1, "01:00.0")]
    [InlineData(3599.999, 2, "1:00:00.00")]
    [InlineData(9000.5, 1, "2:30:00.5")]
    [InlineData(12.0, 0, "00:12")]
    public void Times_have_the_decimals_that_are_asked_for(double seconds, int decimals, string text) => Assert.Equal(text, ClockText.Format(seconds, decimals));
}
