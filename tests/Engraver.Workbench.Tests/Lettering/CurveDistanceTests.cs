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
        Assert.Equal(0.25, CurveDistance.Of(new Vector3D(3.0 * fraction, 0.25, 0.0), at => new Vector3D(3.0 * at, 0.0, 0.0)), 9);
}
