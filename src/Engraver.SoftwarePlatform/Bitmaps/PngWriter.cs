using System.Buffers.Binary;
using System.IO.Compression;
using Engraver.SoftwarePlatform.Rasteriser;

namespace Engraver.SoftwarePlatform.Bitmaps;

internal static class PngWriter
{
    private const byte FilterUp = 2;

    public static void Write(Stream stream, SoftwareBitmap bitmap)
    {
        stream.Write(PngChunk.Signature);
        PngChunk.Write(stream, "IHDR"u8, Header(bitmap, PngColorType.TrueColorWithAlpha));
        PngChunk.Write(stream, "pHYs"u8, Resolution(bitmap));
        PngChunk.Write(stream, "IDAT"u8, CompressedRows(bitmap));
        PngChunk.Write(stream, "IEND"u8, []);
    }

    public static byte[] Header(SoftwareBitmap bitmap, PngColorType type)
    {
        var header = new byte[13];
        BinaryPrimitives.WriteInt32BigEndian(header, bitmap.PixelSize.Width);
        BinaryPrimitives.WriteInt32BigEndian(header.AsSpan(4), bitmap.PixelSize.Height);
        header[8] = 8;
        header[9] = (byte)type;
        return header;
    }

    public static byte[] Resolution(SoftwareBitmap bitmap)
    {
        var data = new byte[9];
        BinaryPrimitives.WriteInt32BigEndian(data, (int)Math.Round(bitmap.Dpi.X / PngHeader.MetresPerInch));
        BinaryPrimitives.WriteInt32BigEndian(data.AsSpan(4), (int)Math.Round(bitmap.Dpi.Y / PngHeader.MetresPerInch));
        data[8] = 1;
        return data;
    }

    /// <summary>Row after row, not premultiplied, red in the lowest byte.</summary>
    public static uint[] PlainPixels(SoftwareBitmap bitmap)
    {
        var (width, height) = (bitmap.PixelSize.Width, bitmap.PixelSize.Height);
        var pixels = new uint[width * height];
        for (var i = 0; i < pixels.Length; i++) pixels[i] = PixelArithmetic.Swapped(PixelArithmetic.Unpremultiplied(bitmap[i % width, i / width]));
        return pixels;
    }

    private static byte[] CompressedRows(SoftwareBitmap bitmap)
    {
        using var memory = new MemoryStream();
        using (var compressor = new ZLibStream(memory, CompressionLevel.Optimal, leaveOpen: true))
        {
            var row = new byte[bitmap.PixelSize.Width * 4];
            var above = new byte[row.Length];
            var line = new byte[row.Length + 1];
            line[0] = FilterUp;
            for (var y = 0; y < bitmap.PixelSize.Height; y++)
            {
                Fill(row, bitmap, y);
                for (var i = 0; i < row.Length; i++)
                    line[i + 1] = (byte)(row[i] - above[i]);
                compressor.Write(line);
                (row, above) = (above, row);
            }
        }
        return memory.ToArray();
    }

    private static void Fill(Span<byte> bytes, SoftwareBitmap bitmap, int y)
    {
        var pixels = bitmap.Row(y);
        for (var x = 0; x < pixels.Length; x++)
        {
            var pixel = PixelArithmetic.Swapped(PixelArithmetic.Unpremultiplied(bitmap.Converted(pixels[x])));
            BinaryPrimitives.WriteUInt32LittleEndian(bytes[(4 * x)..], pixel);
        }
    }
}
