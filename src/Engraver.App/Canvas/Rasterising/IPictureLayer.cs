using Engraver.App.Canvas.Views;

namespace Engraver.App.Canvas.Rasterising;

/// <summary>One layer of a picture. Painted tile by tile from several threads at once.</summary>
internal interface IPictureLayer
{
    /// <summary>Draws the part of the layer that the tile shows.</summary>
    void Paint(CanvasView view, PixelTile tile);
}
