using Engraver.Core.Geometry;
using FsCheck;
using FsCheck.Xunit;

namespace Engraver.Core.Tests.Geometry;

public class AngleTests
{
    [Theory]
    [InlineData(0, 1, 0)]
    [InlineData(90, 0, 1)]
    [InlineData(180, -1, 0)]
    [InlineData(270, 0, -1)]
    [InlineData(-90, 0, -1)]
    [InlineData(450, 0, 1)]
    [InlineData(-360, 1, 0)]
    public void Sine_and_cosine_are_exact_at_every_quadrant(double degrees, double cos, double sin)
    {
        var angle = Angle.FromDegrees(degrees);

        Assert.Equal(cos, angle.Cos());
        Assert.Equal(sin, angle.Sin());
    }

    [Property]
    public bool Positive_stays_below_a_whole_turn_and_keeps_the_direction(NormalFloat number)
    {
        var angle = Angle.FromDegrees(number.Get % 1e6);
        var turned = angle.Positive();
        return turned.Degrees is >= 0.0 and < 360.0 && Math.Abs(turned.Cos() - angle.Cos()) < 1e-9 && Math.Abs(turned.Sin() - angle.Sin()) < 1e-9;
    }

    [Fact]
    public void A_tiny_negative_angle_does_not_become_a_whole_turn() => Assert.Equal(0.0, Angle.FromDegrees(-1e-20).Positive().Degrees);
}
