using Avalonia;
using Engraver.SoftwarePlatform.Windows;

namespace Engraver.SoftwarePlatform.Tests.Windows;

public sealed class FrameDifferenceTests
{
    private static readonly PixelSize s_size = new(200, 100);
    private readonly FrameDifference _difference = new();
    private readonly uint[] _pixels = new uint[s_size.Width * s_size.Height];

    [Fact]
    public void The_first_frame_and_one_of_another_size_differ_everywhere()
    {
        Assert.Equal([new PixelRect(s_size)], _difference.Take(_pixels, s_size));
        Assert.Empty(_difference.Take(_pixels, s_size));
        Assert.Equal([new PixelRect(0, 0, 100, 200)], _difference.Take(_pixels, new PixelSize(100, 200)));
    }

    [Fact]
    public void One_pixel_is_one_tile_cut_at_the_edge()
    {
        _difference.Take(_pixels, s_size);
        _pixels[99 * 200 + 199] = 1;

        Assert.Equal([new PixelRect(192, 96, 8, 4)], _difference.Take(_pixels, s_size));
        Assert.Empty(_difference.Take(_pixels, s_size));
    }

    [Fact]
    public void Neighbouring_tiles_become_one_rectangle()
    {
        _difference.Take(_pixels, s_size);
        for (var y = 0; y < 64; y++) _pixels.AsSpan(y * 200, 128).Fill(7);

        Assert.Equal([new PixelRect(0, 0, 128, 64)], _difference.Take(_pixels, s_size));
    }

    [Fact]
    public void Rectangles_cover_what_has_changed_and_never_overlap()
    {
        var random = new Random(20261121);
        _difference.Take(_pixels, s_size);
        for (var round = 0; round < 50; round++)
        {
            var changed = Enumerable.Range(0, random.Next(1, 12)).Select(_ => random.Next(_pixels.Length)).ToList();
            foreach (var place in changed) _pixels[place]++;
            var areas = _difference.Take(_pixels, s_size);

            Assert.All(changed, place => Assert.Single(areas, area => area.ContainsExclusive(new PixelPoint(place % 200, place / 200))));
        }
    }
}
