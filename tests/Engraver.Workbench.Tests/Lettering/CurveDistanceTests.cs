using Engraver.Core.Geometry;
using Engraver.Workbench.Lettering;

namespace Engraver.Workbench.Tests.Lettering;

public class CurveDistanceTests
{
    /// <summary>A point beside a curve, also within the last step of the first search, where the end is the nearest of the points tried.</summary>
    [Theory]
    [InlineData(0.0)]
    [InlineData(0.002)]
    [InlineData(0.5)]
    [InlineData(0.997)]
    [InlineData(1.0)]
    public void A_point_beside_a_curve_has_its_distance_wherever_it_is(double fraction) =>
        Assert.Equal(0.25, CurveDistance.Of(new Vector3D(3.0 * fraction, 0.25, 0.0), at => new Vector3D(3.0 * at, 0.0, 0.0), CurveDistance.FewPoints), 9);

    /// <summary>A long spike: the curve returns beside itself at a distance of less than 0.1, and turns between two of the points tried first.</summary>
    [Fact]
    public void A_point_of_a_curve_that_turns_back_on_itself_has_no_distance()
    {
        for (var i = 0; i <= 400; i++) Assert.InRange(CurveDistance.Of(Spike(i / 400.0), Spike, CurveDistance.ManyPoints), 0.0, 1e-4);

        static Vector3D Spike(double at) => new(200.0 * at * (0.97 - at), 0.1 * at, 0.0);
    }
}
