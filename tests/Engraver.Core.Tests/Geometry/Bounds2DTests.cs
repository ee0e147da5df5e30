using Engraver.Core.Geometry;

namespace Engraver.Core.Tests.Geometry;

public class Bounds2DTests
{
    [Fact]
    public void Empty_is_neutral_in_a_union_and_contains_nothing()
    {
        var box = new Bounds2D(1, 2, 3, 4);

        Assert.Equal(box, box.Union(Bounds2D.Empty));
        Assert.True(Bounds2D.Empty.IsEmpty);
        Assert.False(Bounds2D.Empty.Contains(Point2D.Origin));
        Assert.Equal(0.0, Bounds2D.Empty.Width);
    }

    [Fact]
    public void One_point_is_a_box_without_size() => Assert.False(Bounds2D.Empty.Including(new Point2D(5, 6)).IsEmpty);
}
