using Avalonia.Media;

namespace Engraver.SoftwarePlatform.Rasteriser.Paints;

/// <summary>Colours between the stops of a gradient, looked up by offset.</summary>
internal sealed class GradientTable
{
    private const int Steps = 512;

    private readonly uint[] _colors = new uint[Steps + 1];
    private readonly GradientSpreadMethod _spread;

    public GradientTable(IReadOnlyList<IGradientStop> stops, GradientSpreadMethod spread, double opacity)
    {
        _spread = spread;
        var sorted = stops.OrderBy(stop => stop.Offset).ToArray();
        IsOpaque = sorted.Length > 0 && opacity >= 1 && sorted.All(stop => stop.Color.A == 255);
        if (sorted.Length == 0)
            return;
        for (var i = 0; i <= Steps; i++)
            _colors[i] = PixelArithmetic.Premultiplied(ColorAt(sorted, (double)i / Steps), opacity);
    }

    public bool IsOpaque { get; }

    public uint Last => _colors[Steps];

    /// <summary>Color at an offset along the gradient; offsets outside 0 to 1 follow the spread method.</summary>
    public uint this[double offset] => _colors[(int)(Spread(offset) * Steps + 0.5)];

    private double Spread(double offset)
    {
        switch (_spread)
        {
            case GradientSpreadMethod.Repeat:
                return offset - Math.Floor(offset);
            case GradientSpreadMethod.Reflect:
                var folded = Math.Abs(offset) % 2;
                return folded > 1 ? 2 - folded : folded;
            default:
                return offset > 0 ? Math.Min(offset, 1) : 0;
        }
    }

    private static Color ColorAt(IGradientStop[] stops, double offset)
    {
        var after = Array.FindIndex(stops, stop => stop.Offset > offset);
        if (after < 0)
            return stops[^1].Color;
        if (after == 0)
            return stops[0].Color;
        var (first, second) = (stops[after - 1], stops[after]);
        var part = (offset - first.Offset) / (second.Offset - first.Offset);
        var (from, to) = (first.Color, second.Color);
        return new Color(Between(from.A, to.A, part), Between(from.R, to.R, part), Between(from.G, to.G, part), Between(from.B, to.B, part));
    }

    private static byte Between(byte from, byte to, double part) => (byte)(from + (to - from) * part + 0.5);
}
