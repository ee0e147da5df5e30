using Avalonia.Media.Imaging;

namespace Engraver.SoftwarePlatform.Rasteriser;

/// <summary>The modes that mix colours (W3C Compositing and Blending Level 1, sections 10.1 and 10.2); colours are not premultiplied here.</summary>
internal static class ColorBlending
{
    public static BlendColor Mix(BitmapBlendingMode mode, BlendColor backdrop, BlendColor source) => mode switch
    {
        BitmapBlendingMode.Hue => WithLuminosity(WithSaturation(source, backdrop.Saturation), backdrop.Luminosity),
        BitmapBlendingMode.Saturation => WithLuminosity(WithSaturation(backdrop, source.Saturation), backdrop.Luminosity),
        BitmapBlendingMode.Color => WithLuminosity(source, backdrop.Luminosity),
        BitmapBlendingMode.Luminosity => WithLuminosity(backdrop, source.Luminosity),
        _ => new BlendColor(Mix(mode, backdrop.Red, source.Red), Mix(mode, backdrop.Green, source.Green), Mix(mode, backdrop.Blue, source.Blue)),
    };

    private static float Mix(BitmapBlendingMode mode, float backdrop, float source) => mode switch
    {
        BitmapBlendingMode.Multiply => backdrop * source,
        BitmapBlendingMode.Screen => Screen(backdrop, source),
        BitmapBlendingMode.Overlay => HardLight(source, backdrop),
        BitmapBlendingMode.Darken => Math.Min(backdrop, source),
        BitmapBlendingMode.Lighten => Math.Max(backdrop, source),
        BitmapBlendingMode.ColorDodge => backdrop <= 0 ? 0 : source >= 1 ? 1 : Math.Min(1, backdrop / (1 - source)),
        BitmapBlendingMode.ColorBurn => backdrop >= 1 ? 1 : source <= 0 ? 0 : 1 - Math.Min(1, (1 - backdrop) / source),
        BitmapBlendingMode.HardLight => HardLight(backdrop, source),
        BitmapBlendingMode.SoftLight => SoftLight(backdrop, source),
        BitmapBlendingMode.Difference => Math.Abs(backdrop - source),
        BitmapBlendingMode.Exclusion => backdrop + source - 2 * backdrop * source,
        _ => source,
    };

    private static float Screen(float backdrop, float source) => backdrop + source - backdrop * source;

    private static float HardLight(float backdrop, float source) => source <= 0.5f ? backdrop * 2 * source : Screen(backdrop, 2 * source - 1);

    private static float SoftLight(float backdrop, float source)
    {
        if (source <= 0.5f)
            return backdrop - (1 - 2 * source) * backdrop * (1 - backdrop);
        var bright = backdrop <= 0.25f ? ((16 * backdrop - 12) * backdrop + 4) * backdrop : MathF.Sqrt(backdrop);
        return backdrop + (2 * source - 1) * (bright - backdrop);
    }

    private static BlendColor WithLuminosity(BlendColor color, float luminosity)
    {
        var change = luminosity - color.Luminosity;
        return Clipped(color + new BlendColor(change, change, change));
    }

    /// <summary>Moves channels outside of 0 to 1 towards gray of the same luminosity.</summary>
    private static BlendColor Clipped(BlendColor color)
    {
        float luminosity = color.Luminosity, lowest = color.Lowest, highest = color.Highest;
        var gray = new BlendColor(luminosity, luminosity, luminosity);
        if (lowest < 0)
            color = gray + (color + gray * -1) * (luminosity / (luminosity - lowest));
        if (highest > 1)
            color = gray + (color + gray * -1) * ((1 - luminosity) / (highest - luminosity));
        return color;
    }

    private static BlendColor WithSaturation(BlendColor color, float saturation)
    {
        float lowest = color.Lowest, range = color.Saturation;
        if (range <= 0)
            return default;
        return (color + new BlendColor(-lowest, -lowest, -lowest)) * (saturation / range);
    }
}
