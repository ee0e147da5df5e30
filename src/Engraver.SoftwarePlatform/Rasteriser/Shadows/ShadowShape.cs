using Avalonia;
using Engraver.SoftwarePlatform.Rasteriser.Paths;

namespace Engraver.SoftwarePlatform.Rasteriser.Shadows;

/// <summary>Everything that determines a soft shadow's mask, in device pixels: equal shapes have equal masks.</summary>
internal readonly record struct ShadowShape(int Width, int Height, Vector TopLeft, Vector TopRight, Vector BottomRight, Vector BottomLeft, ShadowBlur Blur)
{
    /// <summary>The smallest shape with the same corners; longer ones are made by stretching its middle, where nothing changes.</summary>
    /// <param name="box">In device pixels.</param>
    public static ShadowShape Smallest(RoundedRect box, PixelBounds pixels, ShadowBlur blur)
    {
        var radius = new[] { box.RadiiTopLeft, box.RadiiTopRight, box.RadiiBottomRight, box.RadiiBottomLeft }.Max(corner => Math.Max(corner.X, corner.Y));
        var enough = 2 * ((int)Math.Ceiling(Math.Min(radius, Math.Max(pixels.Width, pixels.Height))) + blur.Reach) + 1;
        return new ShadowShape(
            Math.Min(pixels.Width, enough), Math.Min(pixels.Height, enough), box.RadiiTopLeft, box.RadiiTopRight, box.RadiiBottomRight, box.RadiiBottomLeft, blur);
    }

    /// <summary>The blurred mask; the box's top left is the pixel (0, 0).</summary>
    public CoverageMask Draw(DrawingScratch scratch)
    {
        var path = new VectorPath(Avalonia.Media.FillRule.NonZero);
        path.AddRoundedRectangle(new RoundedRect(new Rect(0, 0, Width, Height), TopLeft, TopRight, BottomRight, BottomLeft));
        var mask = ShapeFiller.MaskOf(scratch, path, Matrix.Identity, new PixelBounds(0, 0, Width, Height).Inflate(Blur.Reach));
        Blur.Apply(mask);
        return mask;
    }
}
