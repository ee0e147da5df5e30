using Avalonia;
using Avalonia.Media;
using Avalonia.Media.Immutable;
using Avalonia.Platform;
using Engraver.SoftwarePlatform.Drawing;

namespace Engraver.SoftwarePlatform.Tests.Drawing;

/// <summary>A bitmap to draw on without a window, and methods that read it.</summary>
internal sealed class Picture : IDisposable
{
    public static readonly SoftwareRenderInterface Platform = new();

    public Picture(int width, int height, Color? background = null)
    {
        Bitmap = (DrawableBitmap)Platform.CreateRenderTargetBitmap(new PixelSize(width, height), new Vector(96, 96));
        if (background is { } color)
            Draw(context => context.Clear(color));
    }

    public DrawableBitmap Bitmap { get; }

    public Picture Draw(Action<IDrawingContextImpl> drawing)
    {
        using var context = Bitmap.CreateDrawingContext();
        drawing(context);
        return this;
    }

    /// <summary>Premultiplied, alpha in the highest byte.</summary>
    public uint Pixel(int x, int y) => Bitmap[x, y];

    public Color Color(int x, int y)
    {
        var pixel = Bitmap[x, y];
        return Avalonia.Media.Color.FromArgb((byte)(pixel >> 24), (byte)(pixel >> 16), (byte)(pixel >> 8), (byte)pixel);
    }

    public int Alpha(int x, int y) => (int)(Pixel(x, y) >> 24);

    /// <summary>Sum of the covered parts of all pixels.</summary>
    public double Area()
    {
        long sum = 0;
        for (var y = 0; y < Bitmap.PixelSize.Height; y++)
        {
            for (var x = 0; x < Bitmap.PixelSize.Width; x++)
                sum += Alpha(x, y);
        }
        return sum / 255.0;
    }

    public uint[] Pixels() => [.. Enumerable.Range(0, Bitmap.PixelSize.Height).SelectMany(y => Enumerable.Range(0, Bitmap.PixelSize.Width).Select(x => Pixel(x, y)))];

    public static ImmutableSolidColorBrush Brush(Color color, double opacity = 1) => new(color, opacity);

    public static ImmutablePen Pen(
        Color color,
        double width,
        PenLineCap cap = PenLineCap.Flat,
        PenLineJoin join = PenLineJoin.Miter,
        params double[] dashes) =>
        new(Brush(color), width, dashes.Length == 0 ? null : new ImmutableDashStyle(dashes, 0), cap, join);

    public static IGeometryImpl Geometry(Action<IStreamGeometryContextImpl> write)
    {
        var geometry = Platform.CreateStreamGeometry();
        using var context = geometry.Open();
        write(context);
        return geometry;
    }

    public void Dispose() => Bitmap.Dispose();
}
