using Avalonia;
using Avalonia.Media;
using Engraver.SoftwarePlatform.Bitmaps;
using Engraver.SoftwarePlatform.Rasteriser;
using Engraver.SoftwarePlatform.Rasteriser.Paints;

namespace Engraver.SoftwarePlatform.Drawing;

/// <summary>Makes paints of image brushes and of brushes that show a visual or a drawing.</summary>
/// <param name="pictures">Receives pictures that must live as long as the paints.</param>
internal sealed class TilePaints(List<IDisposable> pictures)
{
    private const int LargestPicture = 1 << 13;

    public Paint? Create(IBrush brush, Rect area, double opacity, in Matrix toDevice, bool isSmooth)
    {
        if (Content(brush, toDevice) is not { } content)
            return null;
        var layout = TileLayout.From(content.Brush, area, content.Size);
        if (layout.Tile.Width <= 0 || layout.Tile.Height <= 0)
            return null;
        var toPicture = Matrix.CreateScale(content.Resolution, content.Resolution);
        if (content.Brush.TileMode == TileMode.None)
            return Single(content, layout, opacity, toDevice, toPicture, isSmooth);
        return Repeated(content, layout, opacity, toDevice, toPicture, isSmooth);
    }

    /// <summary>A single picture; everything outside it and its tile is transparent.</summary>
    private static ImagePaint? Single(TileContent content, TileLayout layout, double opacity, in Matrix toDevice, in Matrix toPicture, bool isSmooth)
    {
        if (!layout.ContentToBrush.TryInvert(out var toContent) || !toDevice.TryInvert(out var toBrush))
            return null;
        var seen = layout.Tile.TransformToAABB(toContent).Intersect(layout.Source);
        var part = PixelBounds.Snapped(seen.TransformToAABB(toPicture)).Intersect(content.Picture.Bounds);
        if (part.IsEmpty)
            return null;
        return BitmapDrawing.Sampled(content.Picture, toBrush * toContent * toPicture, part, ImageWrap.None, ImageWrap.None, isSmooth, opacity);
    }

    /// <summary>The tile is drawn once, in device resolution, and repeated.</summary>
    private ImagePaint? Repeated(TileContent content, TileLayout layout, double opacity, in Matrix toDevice, in Matrix toPicture, bool isSmooth)
    {
        var scale = Math.Sqrt(Math.Abs(toDevice.GetDeterminant()));
        var size = new PixelSize(Pixels(layout.Tile.Width * scale), Pixels(layout.Tile.Height * scale));
        var tile = new DrawableBitmap(size, new Vector(96, 96));
        pictures.Add(tile);
        var brushToTile = Matrix.CreateTranslation(-layout.Tile.X, -layout.Tile.Y) * Matrix.CreateScale(size.Width / layout.Tile.Width, size.Height / layout.Tile.Height);
        using (var context = tile.OpenContext())
        {
            context.Transform = layout.ContentToBrush * brushToTile;
            context.PushRenderOptions(new RenderOptions { BitmapInterpolationMode = isSmooth ? default : Avalonia.Media.Imaging.BitmapInterpolationMode.None });
            context.DrawBitmap(content.Picture, 1, layout.Source.TransformToAABB(toPicture), layout.Source);
            context.PopRenderOptions();
        }
        if (!toDevice.TryInvert(out var toBrush))
            return null;
        var mode = content.Brush.TileMode;
        var wrapX = mode is TileMode.FlipX or TileMode.FlipXY ? ImageWrap.Mirror : ImageWrap.Repeat;
        var wrapY = mode is TileMode.FlipY or TileMode.FlipXY ? ImageWrap.Mirror : ImageWrap.Repeat;
        return BitmapDrawing.Sampled(tile, toBrush * brushToTile, tile.Bounds, wrapX, wrapY, isSmooth, opacity);
    }

    private TileContent? Content(IBrush brush, in Matrix toDevice)
    {
        if (brush is IImageBrush { Source: { } source } image)
        {
            var bitmap = ImageBrushBitmap.Find(source);
            return bitmap is null ? null : new TileContent(image, bitmap, bitmap.PixelSize.ToSizeWithDpi(bitmap.Dpi), bitmap.Dpi.X / 96);
        }
        var content = brush as ISceneBrushContent ?? (brush as ISceneBrush)?.CreateContent();
        return content is null ? null : Drawn(content, toDevice);
    }

    private TileContent? Drawn(ISceneBrushContent content, in Matrix toDevice)
    {
        var area = content.Rect;
        if (area.Width <= 0 || area.Height <= 0)
            return null;
        var resolution = Math.Max(1, Math.Sqrt(Math.Abs(toDevice.GetDeterminant())));
        var picture = new DrawableBitmap(new PixelSize(Pixels(area.Width * resolution), Pixels(area.Height * resolution)), new Vector(96, 96));
        pictures.Add(picture);
        using var context = picture.OpenContext();
        var place = Matrix.CreateTranslation(-area.X, -area.Y) * Matrix.CreateScale(resolution, resolution);
        context.Transform = place;
        content.Render(context, place);
        return new TileContent(content.Brush, picture, area.Size, resolution);
    }

    private static int Pixels(double length) => (int)Math.Clamp(Math.Ceiling(length - 1e-6), 1, LargestPicture);
}

/// <summary>The content of a tile brush.</summary>
/// <param name="Size">In the brush's units.</param>
/// <param name="Resolution">Pixels of the picture per unit.</param>
internal sealed record TileContent(ITileBrush Brush, SoftwareBitmap Picture, Size Size, double Resolution);
