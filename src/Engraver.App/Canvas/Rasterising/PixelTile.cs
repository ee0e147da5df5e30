namespace Engraver.App.Canvas.Rasterising;

/// <summary>A rectangle of the picture while it is drawn: one layer at a time as colour and coverage, then blended over the previous layers.</summary>
/// <remarks>Within a layer a pixel keeps its largest coverage (0xAARRGGBB, A = coverage 0 to 255), so that segments that meet end to end look like one
/// line, however short they are.</remarks>
internal sealed class PixelTile
{
    public const int Side = 256;
    private readonly uint[] _layer = new uint[Side * Side];
    private int _firstDirty = Side;
    private int _lastDirty = -1;

    public int Left { get; private set; }

    public int Top { get; private set; }

    public int Width { get; private set; }

    public int Height { get; private set; }

    /// <summary>The layer, <see cref="Side"/> pixels to a row.</summary>
    public uint[] Layer => _layer;

    public void MoveTo(int left, int top, int width, int height)
    {
        ArgumentOutOfRangeException.ThrowIfGreaterThan(width, Side);
        ArgumentOutOfRangeException.ThrowIfGreaterThan(height, Side);
        (Left, Top, Width, Height) = (left, top, width, height);
        _layer.AsSpan().Clear();
        (_firstDirty, _lastDirty) = (Side, -1);
    }

    /// <summary>Marks rows of the tile as drawn.</summary>
    public void MarkDirty(int firstRow, int lastRow)
    {
        if (firstRow < _firstDirty) _firstDirty = firstRow;
        if (lastRow > _lastDirty) _lastDirty = lastRow;
    }

    /// <summary>Blends the layer over the picture and starts the next one.</summary>
    /// <param name="pixels">The whole picture.</param>
    /// <param name="stride">Pixels to a row of the picture.</param>
    public void Compose(uint[] pixels, int stride)
    {
        for (var row = Math.Max(0, _firstDirty); row <= Math.Min(_lastDirty, Height - 1); row++)
        {
            var source = _layer.AsSpan(row * Side, Width);
            BlendOver(source, pixels.AsSpan(((Top + row) * stride) + Left, Width));
            source.Clear();
        }

        (_firstDirty, _lastDirty) = (Side, -1);
    }

    private static void BlendOver(ReadOnlySpan<uint> source, Span<uint> target)
    {
        for (var i = 0; i < source.Length; i++)
        {
            var coverage = source[i] >> 24;
            if (coverage == 0) continue;
            target[i] = coverage == 255 ? source[i] : Mixed(target[i], source[i], coverage);
        }
    }

    /// <summary>Interpolates between two opaque colours in 255ths.</summary>
    private static uint Mixed(uint under, uint over, uint coverage)
    {
        var (keep, take) = (255 - coverage, coverage);
        var redBlue = ((under & 0xFF00FF) * keep) + ((over & 0xFF00FF) * take) + 0x800080;
        var green = ((under & 0x00FF00) >> 8) * keep + (((over & 0x00FF00) >> 8) * take) + 0x80;
        redBlue = (redBlue + ((redBlue >> 8) & 0xFF00FF)) >> 8;
        green = (green + (green >> 8)) >> 8;
        return 0xFF000000 | (redBlue & 0xFF00FF) | ((green & 0xFF) << 8);
    }
}
