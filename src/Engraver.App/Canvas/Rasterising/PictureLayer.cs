using Engraver.App.Canvas.Scenes;

namespace Engraver.App.Canvas.Rasterising;

/// <summary>One layer of a picture: primitives, what their colours look like, and the pen.</summary>
/// <param name="Palette">0xAARRGGBB for each palette index; an index beyond it takes the last.</param>
/// <param name="Pen">Pixels of the screen.</param>
internal sealed record PictureLayer(PrimitiveStore Store, uint[] Palette, LinePen Pen)
{
    /// <summary>Only entities for which this is true (by entity index; what lies beyond is left out); null: all.</summary>
    public bool[]? Only { get; init; }
}
