using Avalonia;
using Avalonia.Media;

namespace Engraver.SoftwarePlatform.Drawing;

/// <summary>Positions of the content of a tile brush.</summary>
/// <param name="Tile">First tile, in the brush's coordinates.</param>
/// <param name="Source">Part of the content that is shown.</param>
internal readonly record struct TileLayout(Rect Tile, Rect Source, Matrix ContentToBrush)
{
    public static TileLayout From(ITileBrush brush, Rect area, Size contentSize)
    {
        var tile = brush.DestinationRect.ToPixels(area);
        var source = brush.SourceRect.ToPixels(new Rect(contentSize));
        var scale = brush.Stretch.CalculateScaling(tile.Size, source.Size);
        var free = new Vector(tile.Width - source.Width * scale.X, tile.Height - source.Height * scale.Y);
        var offset = new Vector(free.X * Part(brush.AlignmentX), free.Y * Part(brush.AlignmentY));
        var place = Matrix.CreateTranslation(-source.X, -source.Y)
            * Matrix.CreateScale(scale.X, scale.Y)
            * Matrix.CreateTranslation(tile.X + offset.X, tile.Y + offset.Y);
        return new TileLayout(tile, source, place);
    }

    private static double Part(AlignmentX alignment) => alignment switch
    {
        AlignmentX.Left => 0,
        AlignmentX.Right => 1,
        _ => 0.5,
    };

    private static double Part(AlignmentY alignment) => alignment switch
    {
        AlignmentY.Top => 0,
        AlignmentY.Bottom => 1,
        _ => 0.5,
    };
}
