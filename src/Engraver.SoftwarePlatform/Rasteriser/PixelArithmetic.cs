using System.Runtime.CompilerServices;
using Avalonia.Media;

namespace Engraver.SoftwarePlatform.Rasteriser;

/// <summary>Pixels as one number: blue in the lowest byte, then green, red and alpha, colours multiplied by alpha.</summary>
internal static class PixelArithmetic
{
    private const uint TwoChannels = 0x00FF00FF;

    /// <summary>a * b / 255, rounded; exact for all bytes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint Multiply(uint a, uint b)
    {
        var product = a * b + 128;
        return (product + (product >> 8)) >> 8;
    }

    /// <summary>All four channels times <paramref name="factor"/> / 255.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint Scale(uint pixel, uint factor)
    {
        var even = (pixel & TwoChannels) * factor + 0x00800080;
        var odd = ((pixel >> 8) & TwoChannels) * factor + 0x00800080;
        even = ((even + ((even >> 8) & TwoChannels)) >> 8) & TwoChannels;
        odd = (odd + ((odd >> 8) & TwoChannels)) & ~TwoChannels;
        return even | odd;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint Over(uint source, uint destination) => source + Scale(destination, 255 - (source >> 24));

    /// <summary>Between two pixels; <paramref name="fraction"/> 0 is the first, 256 the second.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint Mix(uint first, uint second, uint fraction)
    {
        var rest = 256 - fraction;
        var even = (((first & TwoChannels) * rest + (second & TwoChannels) * fraction) >> 8) & TwoChannels;
        var odd = (((first >> 8) & TwoChannels) * rest + ((second >> 8) & TwoChannels) * fraction) & ~TwoChannels;
        return even | odd;
    }

    public static uint Premultiplied(uint pixel)
    {
        var alpha = pixel >> 24;
        if (alpha == 255)
            return pixel;
        return alpha << 24 | Multiply((pixel >> 16) & 255, alpha) << 16 | Multiply((pixel >> 8) & 255, alpha) << 8 | Multiply(pixel & 255, alpha);
    }

    public static uint Unpremultiplied(uint pixel)
    {
        var alpha = pixel >> 24;
        if (alpha is 0 or 255)
            return alpha == 0 ? 0 : pixel;
        return alpha << 24 | Divided((pixel >> 16) & 255, alpha) << 16 | Divided((pixel >> 8) & 255, alpha) << 8 | Divided(pixel & 255, alpha);
    }

    /// <summary>Red and blue change places.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint Swapped(uint pixel) => (pixel & ~TwoChannels) | ((pixel & 255) << 16) | ((pixel >> 16) & 255);

    /// <summary>A colour as a premultiplied pixel; <paramref name="opacity"/> from 0 to 1.</summary>
    public static uint Premultiplied(Color color, double opacity)
    {
        var alpha = (uint)Math.Clamp((int)(color.A * opacity + 0.5), 0, 255);
        return Premultiplied(alpha << 24 | (uint)color.R << 16 | (uint)color.G << 8 | color.B);
    }

    public static uint OpacityByte(double opacity) => (uint)(Math.Clamp(opacity, 0, 1) * 255 + 0.5);

    private static uint Divided(uint channel, uint alpha) => Math.Min(255, (channel * 255 + alpha / 2) / alpha);
}
