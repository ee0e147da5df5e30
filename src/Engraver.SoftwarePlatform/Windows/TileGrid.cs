using Avalonia;

namespace Engraver.SoftwarePlatform.Windows;

/// <summary>Marked tiles, and a few rectangles that cover exactly these.</summary>
internal sealed class TileGrid(int columns, int rows)
{
    private readonly bool[] _marked = new bool[columns * rows];

    public void Mark(int column, int row) => _marked[row * columns + column] = true;

    /// <summary>Runs of each row, joined downwards where the next row has the same run. They never overlap. In pixels, cut at the frame's edges.</summary>
    public IReadOnlyList<PixelRect> Rectangles(int tileWidth, int tileHeight, PixelSize frame)
    {
        var done = new List<PixelRect>();
        var open = new List<PixelRect>();
        for (var row = 0; row < rows; row++)
        {
            var runs = Runs(row);
            done.AddRange(open.Where(above => !runs.Exists(run => SameRun(run, above))));
            open = [.. runs.Select(run => open.Find(above => SameRun(run, above)) is { Height: > 0 } above ? new PixelRect(above.X, above.Y, above.Width, above.Height + 1) : run)];
        }

        done.AddRange(open);
        return [.. done.Select(tiles => InPixels(tiles, tileWidth, tileHeight).Intersect(new PixelRect(frame)))];
    }

    private static bool SameRun(PixelRect one, PixelRect other) => one.X == other.X && one.Width == other.Width;

    private static PixelRect InPixels(PixelRect tiles, int width, int height) => new(tiles.X * width, tiles.Y * height, tiles.Width * width, tiles.Height * height);

    private List<PixelRect> Runs(int row)
    {
        var runs = new List<PixelRect>();
        for (var column = 0; column < columns; column++)
        {
            if (!_marked[row * columns + column]) continue;
            var start = column;
            while (column < columns && _marked[row * columns + column]) column++;
            runs.Add(new PixelRect(start, row, column - start, 1));
        }

        return runs;
    }
}
