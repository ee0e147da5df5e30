using Engraver.Core.Machines;
using Engraver.Galil.Language;

namespace Engraver.Galil.Tests.Programs;

/// <summary>The roundings of the controller: even counts/s, even milliseconds (galil-dmc.md F.5).</summary>
public class DmcProfileTests
{
    [Fact]
    public void The_default_machine_cuts_at_20000_and_travels_at_50000_counts_a_second()
    {
        var profile = MachineProfile.Default;

        Assert.Equal((20000, 50000, 50000, 100), (profile.VectorSpeed(), profile.RapidSpeed(profile.Axes.X), profile.RapidSpeed(profile.Axes.Y), profile.SettleMilliseconds()));
    }

    [Theory]
    [InlineData(60.06, 1000.0, 1000.0, 1002, 1002, 1002)] // 1001 is between two even numbers, and is rounded up
    [InlineData(60.0, -640.0, 1000.0, 640, 640, 1000)] // the coarser axis determines the feed
    [InlineData(0.001, 1000.0, 1000.0, 2, 2, 2)] // the lowest speed
    public void Speeds_are_even(double mmPerMinute, double x, double y, int vector, int rapidX, int rapidY)
    {
        var profile = MachineProfile.Default with { Axes = MachineAxes.FromScale(x, y), FeedMmPerMinute = mmPerMinute, RapidMmPerMinute = mmPerMinute };

        Assert.Equal((vector, rapidX, rapidY), (profile.VectorSpeed(), profile.RapidSpeed(profile.Axes.X), profile.RapidSpeed(profile.Axes.Y)));
    }

    [Theory]
    [InlineData(0.0, 0)]
    [InlineData(0.0001, 2)]
    [InlineData(0.001, 2)]
    [InlineData(0.1, 100)]
    [InlineData(0.101, 102)]
    public void A_wait_is_an_even_number_of_milliseconds_and_never_shorter_than_asked(double seconds, int milliseconds) =>
        Assert.Equal(milliseconds, (MachineProfile.Default with { ToolSettleSeconds = seconds }).SettleMilliseconds());
}
