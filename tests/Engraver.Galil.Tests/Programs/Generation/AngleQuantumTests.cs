using Engraver.Galil.Programs.Generation;

namespace Engraver.Galil.Tests.Programs.Generation;

public class AngleQuantumTests
{
    [Theory]
    [InlineData(0.6, 39321)]
    [InlineData(-0.6, -39321)]
    [InlineData(160.38612, 10511063)]
    [InlineData(90.0, 5898240)]
    [InlineData(360.0, 23592960)]
    public void A_number_is_cut_off_not_rounded(double degrees, int steps) => Assert.Equal(steps / 65536.0, new AngleQuantum(1.0 / 65536.0).Quantize(degrees));

    [Fact]
    public void A_coarser_step_is_rounded_to() => Assert.Equal(154.0 / 256.0, new AngleQuantum(1.0 / 256.0).Quantize(0.6));
}
