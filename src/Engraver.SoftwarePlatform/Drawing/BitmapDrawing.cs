using Avalonia;
using Avalonia.Media.Imaging;
using Engraver.SoftwarePlatform.Bitmaps;
using Engraver.SoftwarePlatform.Rasteriser;
using Engraver.SoftwarePlatform.Rasteriser.Paints;

namespace Engraver.SoftwarePlatform.Drawing;

/// <summary>Draws bitmaps: pixel by pixel where they fit the device's pixels, otherwise sampled.</summary>
internal static class BitmapDrawing
{
    private const double OnPixel = 1e-3;

    public static void Draw(ContextStack state, SoftwareBitmap bitmap, double opacity, Rect source, Rect destination)
    {
        if (source.Width <= 0 || source.Height <= 0 || destination.Width <= 0 || destination.Height <= 0 || opacity <= 0)
            return;
        var toDevice = Matrix.CreateTranslation(-source.X, -source.Y)
            * Matrix.CreateScale(destination.Width / source.Width, destination.Height / source.Height)
            * Matrix.CreateTranslation(destination.X, destination.Y)
            * state.Transform;
        var part = PixelBounds.Around(source).Intersect(bitmap.Bounds);
        if (part.IsEmpty)
            return;
        if (IsPixelForPixel(toDevice) && PixelBounds.Snapped(source).Intersect(bitmap.Bounds) == part)
            Copy(state, bitmap, part, PixelBounds.Nearest(toDevice.M31), PixelBounds.Nearest(toDevice.M32), opacity, state.Options.BitmapBlendingMode);
        else if (toDevice.TryInvert(out var toImage))
            state.FillRectangle(destination, Sampled(bitmap, toImage, part, ImageWrap.Clamp, ImageWrap.Clamp, IsSmooth(state.Options), opacity, state.Options.BitmapBlendingMode));
    }

    /// <summary>Draws a group's pixels, which are already device pixels, at their position.</summary>
    public static void PutLayer(ContextStack state, SoftwareBitmap layer, PixelBounds bounds, double opacity) =>
        Copy(state, layer, new PixelBounds(0, 0, bounds.Width, bounds.Height), bounds.Left, bounds.Top, opacity, BitmapBlendingMode.SourceOver);

    public static bool IsSmooth(Avalonia.Media.RenderOptions options) => options.BitmapInterpolationMode != BitmapInterpolationMode.None;

    /// <summary>Uses a halved copy where several image pixels fall on one device pixel.</summary>
    public static ImagePaint Sampled(
        SoftwareBitmap bitmap,
        Matrix toImage,
        PixelBounds part,
        ImageWrap wrapX,
        ImageWrap wrapY,
        bool isSmooth,
        double opacity,
        BitmapBlendingMode mode = BitmapBlendingMode.SourceOver)
    {
        var step = Math.Sqrt(Math.Abs(toImage.GetDeterminant()));
        var halvings = isSmooth && step > 1 ? (int)Math.Round(Math.Log2(step)) : 0;
        while (halvings > 0 && (part.Width >> halvings == 0 || part.Height >> halvings == 0))
            halvings--;
        var readable = bitmap.ForReading(halvings);
        var ratioX = (double)readable.PixelSize.Width / bitmap.PixelSize.Width;
        var ratioY = (double)readable.PixelSize.Height / bitmap.PixelSize.Height;
        var scaledPart = PixelBounds.Around(new Rect(part.Left * ratioX, part.Top * ratioY, part.Width * ratioX, part.Height * ratioY)).Intersect(readable.Bounds);
        return new ImagePaint(
            readable.Source, toImage * Matrix.CreateScale(ratioX, ratioY), scaledPart, wrapX, wrapY, isSmooth, PixelArithmetic.OpacityByte(opacity)) { Mode = mode };
    }

    private static bool IsPixelForPixel(in Matrix matrix) =>
        Math.Abs(matrix.M11 - 1) < 1e-6 && Math.Abs(matrix.M22 - 1) < 1e-6 && Math.Abs(matrix.M12) < 1e-9 && Math.Abs(matrix.M21) < 1e-9
        && Math.Abs(matrix.M31 - Math.Round(matrix.M31)) < OnPixel && Math.Abs(matrix.M32 - Math.Round(matrix.M32)) < OnPixel;

    private static void Copy(ContextStack state, SoftwareBitmap bitmap, PixelBounds part, int offsetX, int offsetY, double opacity, BitmapBlendingMode mode)
    {
        var readable = bitmap.ForReading(0);
        var paint = new PixelCopyPaint(readable.Source, offsetX, offsetY, PixelArithmetic.OpacityByte(opacity)) { Mode = mode };
        var place = part.Offset(offsetX, offsetY);
        ShapeFiller.FillRectangle(state.Painter, new Rect(place.Left, place.Top, place.Width, place.Height), paint, state.Clip);
    }
}
