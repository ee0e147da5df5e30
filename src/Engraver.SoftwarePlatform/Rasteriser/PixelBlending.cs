using Avalonia.Media.Imaging;

namespace Engraver.SoftwarePlatform.Rasteriser;

/// <summary>Mixes a pixel with the one beneath it (W3C Compositing and Blending Level 1, sections 9 and 10). All pixels are premultiplied.</summary>
internal static class PixelBlending
{
    public static uint Blend(BitmapBlendingMode mode, uint source, uint backdrop)
    {
        var (sourceColor, sourceAlpha) = Unpacked(source);
        var (backdropColor, backdropAlpha) = Unpacked(backdrop);
        if (Compositing(mode, sourceAlpha, backdropAlpha) is { } factors)
            return Packed(sourceColor * factors.Source + backdropColor * factors.Backdrop, sourceAlpha * factors.Source + backdropAlpha * factors.Backdrop);
        var mixed = ColorBlending.Mix(mode, Divided(backdropColor, backdropAlpha), Divided(sourceColor, sourceAlpha));
        var color = sourceColor * (1 - backdropAlpha) + backdropColor * (1 - sourceAlpha) + mixed * (sourceAlpha * backdropAlpha);
        return Packed(color, sourceAlpha + backdropAlpha - sourceAlpha * backdropAlpha);
    }

    /// <summary>Factors of both pixels, for modes that depend on their alpha only; null for those that mix colours.</summary>
    private static (float Source, float Backdrop)? Compositing(BitmapBlendingMode mode, float source, float backdrop) => mode switch
    {
        BitmapBlendingMode.Unspecified or BitmapBlendingMode.SourceOver => (1, 1 - source),
        BitmapBlendingMode.Source => (1, 0),
        BitmapBlendingMode.Destination => (0, 1),
        BitmapBlendingMode.DestinationOver => (1 - backdrop, 1),
        BitmapBlendingMode.SourceIn => (backdrop, 0),
        BitmapBlendingMode.DestinationIn => (0, source),
        BitmapBlendingMode.SourceOut => (1 - backdrop, 0),
        BitmapBlendingMode.DestinationOut => (0, 1 - source),
        BitmapBlendingMode.SourceAtop => (backdrop, 1 - source),
        BitmapBlendingMode.DestinationAtop => (1 - backdrop, source),
        BitmapBlendingMode.Xor => (1 - backdrop, 1 - source),
        BitmapBlendingMode.Plus => (1, 1),
        _ => null,
    };

    private static (BlendColor Color, float Alpha) Unpacked(uint pixel) =>
        (new BlendColor((pixel >> 16 & 255) / 255f, (pixel >> 8 & 255) / 255f, (pixel & 255) / 255f), (pixel >> 24) / 255f);

    private static BlendColor Divided(BlendColor color, float alpha) => alpha > 0 ? color * (1 / alpha) : default;

    private static uint Packed(BlendColor color, float alpha)
    {
        var highest = Math.Clamp(alpha, 0, 1);
        return Byte(highest) << 24 | Byte(Math.Min(color.Red, highest)) << 16 | Byte(Math.Min(color.Green, highest)) << 8 | Byte(Math.Min(color.Blue, highest));
    }

    private static uint Byte(float value) => (uint)(Math.Max(0, value) * 255 + 0.5f);
}
