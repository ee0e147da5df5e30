using System.Buffers.Binary;
using System.IO.Compression;
using Avalonia;

namespace Engraver.SoftwarePlatform.Bitmaps;

internal static class PngReader
{
    public static SoftwareBitmap Read(ReadOnlyMemory<byte> file)
    {
        PngHeader? header = null;
        ReadOnlyMemory<byte> palette = default, transparency = default, resolution = default;
        using var compressed = new MemoryStream();
        foreach (var chunk in PngChunk.All(file))
        {
            switch (chunk.Name)
            {
                case "IHDR":
                    header = PngHeader.Parse(chunk.Data.Span);
                    break;
                case "PLTE":
                    palette = chunk.Data;
                    break;
                case "tRNS":
                    transparency = chunk.Data;
                    break;
                case "pHYs":
                    resolution = chunk.Data;
                    break;
                case "IDAT":
                    compressed.Write(chunk.Data.Span);
                    break;
            }
        }
        if (header is not { } known)
            throw new InvalidDataException("The PNG image has no header.");
        compressed.Position = 0;
        return Decode(known, new PngColors(known, palette, transparency), compressed, DotsPerInch(resolution.Span));
    }

    private static SoftwareBitmap Decode(PngHeader header, PngColors colors, Stream compressed, Vector dpi)
    {
        var bitmap = new SoftwareBitmap(new PixelSize(header.Width, header.Height), dpi);
        using var rows = new ZLibStream(compressed, CompressionMode.Decompress);
        try
        {
            foreach (var pass in PngPass.Passes(header.IsInterlaced))
                ReadPass(header, colors, rows, pass, bitmap);
        }
        catch (EndOfStreamException e)
        {
            throw new InvalidDataException("The PNG image has too few rows.", e);
        }
        return bitmap;
    }

    private static void ReadPass(PngHeader header, PngColors colors, ZLibStream rows, PngPass pass, SoftwareBitmap bitmap)
    {
        var columns = pass.Columns(header.Width);
        if (columns <= 0)
            return;
        var row = new byte[header.BytesPerRow(columns)];
        var above = new byte[row.Length];
        for (var i = 0; i < pass.Rows(header.Height); i++)
        {
            var filter = rows.ReadByte();
            rows.ReadExactly(row);
            PngRowFilter.Undo(filter, row, above, header.FilterDistance);
            var target = bitmap.Row(pass.StartY + i * pass.StepY);
            for (var column = 0; column < columns; column++)
                target[pass.StartX + column * pass.StepX] = colors.Pixel(row, column);
            (row, above) = (above, row);
        }
    }

    private static Vector DotsPerInch(ReadOnlySpan<byte> resolution)
    {
        if (resolution.Length < 9 || resolution[8] != 1)
            return new Vector(96, 96);
        var x = BinaryPrimitives.ReadUInt32BigEndian(resolution) * PngHeader.MetresPerInch;
        var y = BinaryPrimitives.ReadUInt32BigEndian(resolution[4..]) * PngHeader.MetresPerInch;
        return x > 0 && y > 0 ? new Vector(Math.Round(x, 1), Math.Round(y, 1)) : new Vector(96, 96);
    }
}

/// <summary>One pass of an interlaced image: its pixels are in every <paramref name="StepX"/>th column and <paramref name="StepY"/>th row.</summary>
internal readonly record struct PngPass(int StartX, int StartY, int StepX, int StepY)
{
    private static readonly PngPass[] s_whole = [new(0, 0, 1, 1)];

    private static readonly PngPass[] s_adam7 =
    [
        new(0, 0, 8, 8), new(4, 0, 8, 8), new(0, 4, 4, 8), new(2, 0, 4, 4), new(0, 2, 2, 4), new(1, 0, 2, 2), new(0, 1, 1, 2),
    ];

    public int Columns(int width) => (width - StartX + StepX - 1) / StepX;

    public int Rows(int height) => (height - StartY + StepY - 1) / StepY;

    public static IReadOnlyList<PngPass> Passes(bool isInterlaced) => isInterlaced ? s_adam7 : s_whole;
}
