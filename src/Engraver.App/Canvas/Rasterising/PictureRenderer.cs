using Engraver.App.Canvas.Views;

namespace Engraver.App.Canvas.Rasterising;

/// <summary>Draws a whole picture, tile by tile, on all cores.</summary>
internal static class PictureRenderer
{
    /// <summary>The picture of some layers, the first one lowest.</summary>
    /// <exception cref="OperationCanceledException">Cancelled; checked before each tile.</exception>
    public static Picture Render(IReadOnlyList<IPictureLayer> layers, CanvasView view, Backdrop backdrop, CancellationToken stop)
    {
        var picture = new Picture(view);
        var columns = (view.Size.Width + PixelTile.Side - 1) / PixelTile.Side;
        var rows = (view.Size.Height + PixelTile.Side - 1) / PixelTile.Side;
        var next = -1;
        Parallel.For(0, Math.Max(1, Environment.ProcessorCount), new ParallelOptions { CancellationToken = stop }, _ =>
        {
            var tile = new PixelTile();
            for (var index = Interlocked.Increment(ref next); index < columns * rows; index = Interlocked.Increment(ref next))
            {
                stop.ThrowIfCancellationRequested();
                Draw(picture, layers, backdrop, tile, index % columns * PixelTile.Side, index / columns * PixelTile.Side);
            }
        });
        return picture;
    }

    /// <summary>Draws one rectangle of a picture.</summary>
    internal static void Draw(Picture picture, IReadOnlyList<IPictureLayer> layers, Backdrop backdrop, PixelTile tile, int left, int top)
    {
        tile.MoveTo(left, top, Math.Min(PixelTile.Side, picture.Width - left), Math.Min(PixelTile.Side, picture.Height - top));
        backdrop.Fill(picture, left, top, tile.Width, tile.Height);
        foreach (var layer in layers)
        {
            layer.Paint(picture.View, tile);
            tile.Compose(picture.Pixels, picture.Width);
        }
    }
}
