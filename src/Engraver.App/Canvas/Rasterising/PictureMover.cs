using Engraver.App.Canvas.Views;
using Engraver.Core.Geometry;

namespace Engraver.App.Canvas.Rasterising;

/// <summary>Moves and scales the last picture to another view; the result is shown while a new one is drawn.</summary>
internal static class PictureMover
{
    /// <summary>Every pixel takes the value of the old picture under its centre, or the background where the old picture has none.</summary>
    public static void Move(Picture from, CanvasView to, uint background, Span<uint> target, int stride)
    {
        var columns = Sources(to.Size.Width, from.Width, x => from.View.ToPixels(to.ToDrawing(new Point2D(x + 0.5, 0.0))).X);
        var rows = Sources(to.Size.Height, from.Height, y => from.View.ToPixels(to.ToDrawing(new Point2D(0.0, y + 0.5))).Y);
        for (var y = 0; y < rows.Length; y++)
        {
            var line = target.Slice(y * stride, columns.Length);
            if (rows[y] < 0) line.Fill(background);
            else CopyRow(from.Pixels.AsSpan(rows[y] * from.Width, from.Width), columns, background, line);
        }
    }

    private static void CopyRow(ReadOnlySpan<uint> source, int[] columns, uint background, Span<uint> line)
    {
        for (var x = 0; x < columns.Length; x++)
        {
            var column = columns[x];
            line[x] = (uint)column < (uint)source.Length ? source[column] : background;
        }
    }

    /// <summary>The column or row of the old picture for each pixel of the new one; -1 for none.</summary>
    private static int[] Sources(int count, int available, Func<int, double> placeOf)
    {
        var sources = new int[count];
        for (var i = 0; i < count; i++)
        {
            var place = Math.Floor(placeOf(i));
            sources[i] = place >= 0.0 && place < available ? (int)place : -1;
        }

        return sources;
    }
}
