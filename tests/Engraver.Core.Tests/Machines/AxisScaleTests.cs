using Engraver.Core.Machines;

namespace Engraver.Core.Tests.Machines;

public class AxisScaleTests
{
    [Fact]
    public void A_mirrored_axis_turns_positions_and_keeps_lengths()
    {
        var scale = new AxisScale(-800.0);

        Assert.Equal((-1600.0, 2.0), (scale.Exact(2.0), scale.ToMillimetres(-1600.0)));
        Assert.Equal((1600.0, 2.0), (scale.CountsOf(2.0), scale.LengthOf(1600.0)));
        Assert.Equal((true, -1, 800.0), (scale.IsMirrored, scale.Sign, scale.Mirrored().CountsPerMillimetre));
    }

    [Fact]
    public void A_measured_move_keeps_the_direction_of_the_axis() =>
        Assert.Equal((-500.0, 500.0), (new AxisScale(-1.0).Measured(1000.0, 2.0).CountsPerMillimetre, new AxisScale(1.0).Measured(1000.0, 2.0).CountsPerMillimetre));

    [Fact]
    public void The_coarser_axis_has_the_longer_count_whatever_is_mirrored()
    {
        var scale = CountsScale.From(-1000.0, 800.0, -400.0);

        Assert.Equal((800.0, 1000.0), (scale.Coarser.CountsPerMillimetre, scale.Finer.CountsPerMillimetre));
        Assert.Equal(Math.Sqrt(1e6 + 64e4 + 16e4), scale.Diagonal.CountsPerMillimetre);
        Assert.False(scale.IsUniform);
    }

    [Fact]
    public void A_machine_without_an_axis_has_no_scale_for_it() => Assert.True(CountsScale.From(1.0, 1.0).Z is { IsNone: true, IsUsable: false });

    /// <summary>A record prints its properties: one of its own type would never end.</summary>
    [Fact]
    public void A_scale_can_be_printed() => Assert.Contains("-800", CountsScale.From(1000.0, -800.0).ToString(), StringComparison.Ordinal);
}
