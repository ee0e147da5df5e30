using System.Buffers.Binary;
using Engraver.SoftwarePlatform.Rasteriser;

namespace Engraver.SoftwarePlatform.Bitmaps;

/// <summary>Converts the samples of a row to premultiplied pixels; of 16-bit samples only the upper half is used.</summary>
internal sealed class PngColors
{
    private readonly PngHeader _header;
    private readonly ReadOnlyMemory<byte> _palette;
    private readonly ReadOnlyMemory<byte> _paletteAlpha;
    private readonly int[]? _transparent;

    public PngColors(PngHeader header, ReadOnlyMemory<byte> palette, ReadOnlyMemory<byte> transparency)
    {
        _header = header;
        _palette = palette;
        if (header.ColorType == PngColorType.Palette)
            _paletteAlpha = transparency;
        else if (header.ColorType is PngColorType.Gray or PngColorType.TrueColor && transparency.Length >= 2 * header.Channels)
            _transparent = [.. Enumerable.Range(0, header.Channels).Select(i => (int)BinaryPrimitives.ReadUInt16BigEndian(transparency.Span[(2 * i)..]))];
    }

    public uint Pixel(ReadOnlySpan<byte> row, int column)
    {
        switch (_header.ColorType)
        {
            case PngColorType.Palette:
                return FromPalette(Sample(row, column, 0));
            case PngColorType.Gray or PngColorType.GrayWithAlpha:
                var gray = Byte(Sample(row, column, 0));
                return Joined(gray, gray, gray, _header.ColorType == PngColorType.Gray ? OpaqueUnlessMarked(row, column) : Byte(Sample(row, column, 1)));
            default:
                var alpha = _header.ColorType == PngColorType.TrueColor ? OpaqueUnlessMarked(row, column) : Byte(Sample(row, column, 3));
                return Joined(Byte(Sample(row, column, 0)), Byte(Sample(row, column, 1)), Byte(Sample(row, column, 2)), alpha);
        }
    }

    private uint FromPalette(int index)
    {
        if (3 * index + 2 >= _palette.Length)
            throw new InvalidDataException("A pixel of the PNG image is not in its palette.");
        var color = _palette.Span[(3 * index)..];
        var alpha = index < _paletteAlpha.Length ? _paletteAlpha.Span[index] : 255u;
        return Joined(color[0], color[1], color[2], alpha);
    }

    /// <summary>One color may be marked as transparent; it is compared with all its bits.</summary>
    private uint OpaqueUnlessMarked(ReadOnlySpan<byte> row, int column)
    {
        if (_transparent is null)
            return 255;
        for (var channel = 0; channel < _transparent.Length; channel++)
        {
            if (Sample(row, column, channel) != _transparent[channel])
                return 255;
        }
        return 0;
    }

    private int Sample(ReadOnlySpan<byte> row, int column, int channel)
    {
        var index = column * _header.Channels + channel;
        switch (_header.BitDepth)
        {
            case 8:
                return row[index];
            case 16:
                return BinaryPrimitives.ReadUInt16BigEndian(row[(2 * index)..]);
            default:
                var bit = index * _header.BitDepth;
                return (row[bit / 8] >> (8 - _header.BitDepth - bit % 8)) & ((1 << _header.BitDepth) - 1);
        }
    }

    private uint Byte(int sample) => _header.BitDepth switch
    {
        8 => (uint)sample,
        16 => (uint)sample >> 8,
        _ => (uint)(sample * 255 / ((1 << _header.BitDepth) - 1)),
    };

    private static uint Joined(uint red, uint green, uint blue, uint alpha) =>
        PixelArithmetic.Premultiplied(alpha << 24 | red << 16 | green << 8 | blue);
}
