using Avalonia;
using Avalonia.Platform;
using Engraver.SoftwarePlatform.Geometry;

namespace Engraver.SoftwarePlatform.Tests.Geometry;

public class RegionTests
{
    [Fact]
    public void Overlapping_rectangles_are_kept_without_overlap()
    {
        using var region = new SoftwareRegion();
        region.AddRect(Rectangle(0, 0, 10, 10));
        region.AddRect(Rectangle(5, 5, 15, 15));

        Assert.Equal(100 + 100 - 25, region.Rects.Sum(r => (r.Right - r.Left) * (r.Bottom - r.Top)));
        Assert.Equal((0, 0, 15, 15), (region.Bounds.Left, region.Bounds.Top, region.Bounds.Right, region.Bounds.Bottom));
        Assert.True(region.Contains(new Point(12, 12)));
        Assert.False(region.Contains(new Point(12, 2)));
    }

    [Fact]
    public void An_empty_rectangle_adds_nothing()
    {
        using var region = new SoftwareRegion();
        region.AddRect(Rectangle(5, 5, 5, 9));

        Assert.True(region.IsEmpty);
        region.AddRect(Rectangle(1, 1, 2, 2));
        Assert.False(region.IsEmpty);
        region.Reset();
        Assert.True(region.IsEmpty);
    }

    internal static LtrbPixelRect Rectangle(int left, int top, int right, int bottom) => new() { Left = left, Top = top, Right = right, Bottom = bottom };
}
