using Engraver.App.Plots;

namespace Engraver.App.Tests.Plots;

public sealed class ChartTicksTests
{
    [Theory]
    [InlineData(3186.0, 300.0, 500.0, 3500.0)]
    [InlineData(1200.0, 300.0, 200.0, 1200.0)]
    [InlineData(0.37, 120.0, 0.2, 0.4)]
    [InlineData(1e6, 1.0, 1e6, 1e6)]
    public void Speeds_are_round_and_the_top_is_not_below_the_peak(double peak, double pixels, double step, double top)
    {
        var marks = ChartTicks.Speeds(peak, pixels);

        Assert.Equal(0.0, marks[0]);
        Assert.Equal(step, marks[1] - marks[0], 9);
        Assert.Equal(top, marks[^1], 9);
    }

    [Theory]
    [InlineData(49.0, 300.0, 10.0, 40.0)]
    [InlineData(60.0, 60.0, 60.0, 60.0)]
    [InlineData(5400.0, 400.0, 900.0, 5400.0)]
    [InlineData(1e6, 300.0, 2e5, 1e6)]
    public void Times_are_steps_of_a_clock_and_not_beyond_the_end(double total, double pixels, double step, double last)
    {
        var marks = ChartTicks.Seconds(total, pixels);

        Assert.Equal(step, marks[1] - marks[0], 6);
        Assert.Equal(last, marks[^1], 3);
        Assert.True(step / total * Math.Max(pixels, 60.0) >= 59.999, "labels touch");
    }
}
