using Avalonia;
using Avalonia.Media.Imaging;
using Engraver.SoftwarePlatform.Bitmaps;

namespace Engraver.SoftwarePlatform.Tests.Drawing;

/// <summary>A bitmap of the type that brushes need, around a <see cref="SoftwareBitmap"/>.</summary>
internal sealed class TestImage(SoftwareBitmap bitmap) : Bitmap(bitmap)
{
    /// <summary>Squares of <paramref name="cell"/> pixels in four colours: red, green, blue, white.</summary>
    public static SoftwareBitmap FourColors(int cell)
    {
        var bitmap = new SoftwareBitmap(new PixelSize(2 * cell, 2 * cell), new Vector(96, 96));
        for (var y = 0; y < 2 * cell; y++)
        {
            for (var x = 0; x < 2 * cell; x++)
                bitmap.Row(y)[x] = (x / cell, y / cell) switch { (0, 0) => 0xFFFF0000, (1, 0) => 0xFF00FF00, (0, 1) => 0xFF0000FF, _ => 0xFFFFFFFF };
        }
        bitmap.Changed();
        return bitmap;
    }
}
