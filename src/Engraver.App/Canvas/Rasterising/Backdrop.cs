using Engraver.App.Canvas.Colours;
using Engraver.App.Canvas.Views;

namespace Engraver.App.Canvas.Rasterising;

/// <summary>The lowest layer: the background, the grid and the two axes. Grid lines are whole pixels, so that a picture needs only a level for each column
/// and row.</summary>
internal sealed class Backdrop
{
    private const byte Minor = 1;
    private const byte Major = 2;
    private const byte Axis = 3;
    private const byte AxisY = 4;

    /// <summary>2^53: adding one to a larger double does not change it.</summary>
    private const double LargestLine = 9_007_199_254_740_992.0;

    private readonly uint[] _colours;
    private readonly byte[] _columns;
    private readonly byte[] _rows;

    private Backdrop(uint[] colours, byte[] columns, byte[] rows) => (_colours, _columns, _rows) = (colours, columns, rows);

    /// <param name="grid">Whether the grid is on; the axes belong to it.</param>
    public static Backdrop For(CanvasView view, CanvasTheme theme, bool grid)
    {
        var (columns, rows) = (new byte[view.Size.Width], new byte[view.Size.Height]);
        if (grid)
        {
            var step = GridStep.For(view.UnitsPerPixel);
            Mark(columns, view.Window.MinX, view.Window.MaxX, step, x => view.ToPixels(new(x, 0.0)).X);
            Mark(rows, view.Window.MinY, view.Window.MaxY, step, y => view.ToPixels(new(0.0, y)).Y);
        }

        for (var i = 0; i < columns.Length; i++) columns[i] = columns[i] == Axis ? AxisY : columns[i];
        return new Backdrop([theme.Background, theme.MinorGrid, theme.MajorGrid, theme.AxisX, theme.AxisY], columns, rows);
    }

    public void Fill(Picture picture, int left, int top, int width, int height)
    {
        for (var y = top; y < top + height; y++)
        {
            var line = picture.Pixels.AsSpan((y * picture.Width) + left, width);
            var row = _rows[y];
            for (var x = 0; x < line.Length; x++) line[x] = _colours[Math.Max(row, _columns[left + x])];
        }
    }

    /// <summary>Marks the lines between two positions. None are marked if numbers of that size cannot distinguish them (zoomed in far from zero).</summary>
    private static void Mark(byte[] levels, double from, double to, GridStep step, Func<double, double> toPixel)
    {
        var (first, last) = (Math.Ceiling(from / step.Minor), Math.Floor(to / step.Minor));
        if (!(Math.Max(Math.Abs(first), Math.Abs(last)) < LargestLine)) return;
        for (var line = first; line <= last; line++)
        {
            var pixel = (int)Math.Floor(toPixel(line * step.Minor));
            if ((uint)pixel >= (uint)levels.Length) continue;
            levels[pixel] = Math.Max(levels[pixel], line == 0.0 ? Axis : line % step.MinorPerMajor == 0.0 ? Major : Minor);
        }
    }
}
