using Engraver.App.Canvas.Flattening;
using Engraver.App.Canvas.Rasterising;
using Engraver.App.Canvas.Views;
using Engraver.Core.Geometry;

namespace Engraver.App.Canvas.Marks;

/// <summary>The marks of one view. Of marks that would overlap only the first in order is drawn; zooming in shows the others. If there are very many they
/// are small, so that the drawing stays visible between them.</summary>
internal sealed class MarkLayer : IPictureLayer
{
    private const double CellSize = 8.0;

    /// <summary>Maximum number of marks of full size in one picture.</summary>
    private const int MaxFullSizeMarks = 1000;

    /// <summary>Size of a mark above that number, as a fraction of full size.</summary>
    private const double SmallSize = 0.15;
    private readonly List<(SceneMark Mark, Point2D Pixel)> _placed = [];
    private readonly uint _colour;
    private readonly double _scale;

    /// <param name="marks">Ordered by importance.</param>
    /// <param name="scale">Pixels of the screen per pixel of the design.</param>
    public MarkLayer(IReadOnlyList<SceneMark> marks, CanvasView view, uint colour, double scale)
    {
        (_colour, _scale) = (colour, scale);
        var taken = new HashSet<(int, int)>();
        foreach (var mark in marks)
        {
            var reach = MarkShape.ReachOf(mark, scale);
            var pixel = view.ToPixels(mark.Place);
            if (!IsVisible(pixel, reach, view) || !TryReserve(taken, pixel, mark)) continue;
            _placed.Add((mark, pixel));
        }
    }

    /// <summary>The number of marks that are drawn.</summary>
    public int Count => _placed.Count;

    public void Paint(CanvasView view, PixelTile tile)
    {
        var pencil = new Pencil(tile, _colour, new LinePen(1.25 * _scale));
        var size = _placed.Count > MaxFullSizeMarks ? SmallSize * _scale : _scale;
        foreach (var (mark, pixel) in _placed)
        {
            var reach = MarkShape.ReachOf(mark, _scale) + 2.0;
            if (pixel.X + reach < tile.Left || pixel.X - reach > tile.Left + tile.Width || pixel.Y + reach < tile.Top || pixel.Y - reach > tile.Top + tile.Height) continue;
            MarkShape.Draw(mark, pixel, mark.Kind == MarkKind.Order ? _scale : size, ref pencil);
        }
    }

    private static bool IsVisible(Point2D pixel, double reach, CanvasView view) =>
        pixel.X >= -reach && pixel.Y >= -reach && pixel.X <= view.Size.Width + reach && pixel.Y <= view.Size.Height + reach;

    /// <summary>Reserves the cells of the screen that the mark needs; false if one of them is taken.</summary>
    private bool TryReserve(HashSet<(int, int)> taken, Point2D pixel, in SceneMark mark)
    {
        var cell = CellSize * _scale;
        var (right, up) = mark.Kind == MarkKind.Order ? (MarkShape.ReachOf(mark, _scale) - cell, 2) : (0.0, 1);
        var (first, last, row) = ((int)Math.Floor(pixel.X / cell), (int)Math.Floor((pixel.X + right) / cell), (int)Math.Floor(pixel.Y / cell));
        for (var column = first; column <= last; column++)
        {
            for (var line = 0; line < up; line++)
            {
                if (taken.Contains((column, row - line))) return false;
            }
        }

        for (var column = first; column <= last; column++)
        {
            for (var line = 0; line < up; line++) taken.Add((column, row - line));
        }

        return true;
    }

    private readonly struct Pencil(PixelTile tile, uint colour, LinePen pen) : IChordSink
    {
        public void Chord(double fromX, double fromY, double toX, double toY) => LineRasteriser.Draw(tile, fromX, fromY, toX, toY, colour, pen);
    }
}
