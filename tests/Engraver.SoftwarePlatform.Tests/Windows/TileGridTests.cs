using Avalonia;
using Engraver.SoftwarePlatform.Windows;

namespace Engraver.SoftwarePlatform.Tests.Windows;

public sealed class TileGridTests
{
    private const int Width = 64;
    private const int Height = 32;

    /// <summary>The rectangles cover every marked pixel once, and no other pixel.</summary>
    [Fact]
    public void The_rectangles_cover_exactly_what_is_marked()
    {
        var random = new Random(3);
        for (var round = 0; round < 100; round++)
        {
            var (columns, rows) = (random.Next(1, 9), random.Next(1, 9));
            var (grid, marked) = (new TileGrid(columns, rows), new HashSet<(int, int)>());
            for (var i = random.Next(columns * rows + 1); i > 0; i--)
            {
                var (column, row) = (random.Next(columns), random.Next(rows));
                grid.Mark(column, row);
                marked.Add((column, row));
            }

            var frame = new PixelSize(columns * Width, rows * Height);
            var covered = grid.Rectangles(Width, Height, frame).SelectMany(Tiles).ToList();
            Assert.Equal(covered.Count, covered.Distinct().Count());
            Assert.True(marked.SetEquals(covered), $"round {round}");
        }
    }

    [Fact]
    public void Equal_runs_below_each_other_are_one_rectangle()
    {
        var grid = new TileGrid(4, 4);
        foreach (var row in new[] { 1, 2, 3 })
        {
            grid.Mark(1, row);
            grid.Mark(2, row);
        }

        Assert.Equal([new PixelRect(Width, Height, 2 * Width, 3 * Height)], grid.Rectangles(Width, Height, new PixelSize(4 * Width, 4 * Height)));
    }

    [Fact]
    public void What_is_marked_beyond_the_frame_is_cut_at_its_edge()
    {
        var grid = new TileGrid(2, 2);
        grid.Mark(1, 1);

        Assert.Equal([new PixelRect(Width, Height, 6, 8)], grid.Rectangles(Width, Height, new PixelSize(Width + 6, Height + 8)));
    }

    private static IEnumerable<(int, int)> Tiles(PixelRect rectangle) =>
        from row in Enumerable.Range(rectangle.Y / Height, rectangle.Height / Height) from column in Enumerable.Range(rectangle.X / Width, rectangle.Width / Width) select (column, row);
}
