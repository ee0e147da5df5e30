using Engraver.Core.Drawings;

namespace Engraver.App.Canvas.Colours;

/// <summary>The 255 colours of the AutoCAD colour index as 0xAARRGGBB. Index 0 (by block) and 7 (white or black, by background) are the foreground.</summary>
/// <remarks>1 to 9 are named colours and greys; 10 to 249 are 24 hues 15 degrees apart, five values each, full and half saturated; 250 to 255 are
/// greys.</remarks>
public static class AciPalette
{
    public const int Count = 256;

    /// <summary>The index that is white on a dark and black on a light background.</summary>
    public const int Foreground = 7;

    private const int FirstHue = 10;
    private const int FirstGrey = 250;

    private static readonly uint[] s_named = [0, 0xFF0000, 0xFFFF00, 0x00FF00, 0x00FFFF, 0x0000FF, 0xFF00FF, 0xFFFFFF, 0x808080, 0xC0C0C0];
    private static readonly uint[] s_greys = [0x333333, 0x505050, 0x696969, 0x828282, 0xBEBEBE, 0xFFFFFF];
    private static readonly double[] s_values = [255.0, 165.0, 127.0, 76.0, 38.0];

    /// <param name="index">0 to 255.</param>
    /// <param name="foreground">The colour of the indices 0 and 7 on this background, 0xAARRGGBB.</param>
    public static uint ColourOf(int index, uint foreground)
    {
        ArgumentOutOfRangeException.ThrowIfNegative(index);
        ArgumentOutOfRangeException.ThrowIfGreaterThanOrEqual(index, Count);
        if (index is 0 or Foreground) return foreground;
        var rgb = index < FirstHue ? s_named[index] : index < FirstGrey ? Hued(index) : s_greys[index - FirstGrey];
        return 0xFF000000 | rgb;
    }

    /// <summary>The colour of a resolved index or true colour.</summary>
    /// <param name="foreground">As above.</param>
    public static uint ColourOf(DrawingColour colour, uint foreground) => colour.Rgb is { } rgb ? 0xFF000000 | rgb : ColourOf(colour.Index ?? Foreground, foreground);

    private static uint Hued(int index)
    {
        var value = s_values[index % 10 / 2];
        var lift = index % 2 == 0 ? 0.0 : 0.5;
        var hue = ((index / 10) - 1) / 4.0; // in sixths of the circle: one side of the colour hexagon is four steps
        return (Channel(hue, 0.0) << 16) | (Channel(hue, 4.0) << 8) | Channel(hue, 2.0);

        uint Channel(double at, double shift)
        {
            var part = RedFraction((at + shift) % 6.0) * value;
            return (uint)(part + ((value - part) * lift));
        }
    }

    /// <summary>The fraction of red (0 to 1) at a position on the colour hexagon, in sixths of the circle: 1 around red, 0 around cyan.</summary>
    private static double RedFraction(double sixths) => Math.Clamp(Math.Abs(sixths - 3.0) - 1.0, 0.0, 1.0);
}
