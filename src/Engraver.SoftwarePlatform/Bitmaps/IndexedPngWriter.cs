using System.IO.Compression;

namespace Engraver.SoftwarePlatform.Bitmaps;

/// <summary>Writes a picture with one byte per pixel.</summary>
internal static class IndexedPngWriter
{
    private const int ColourBytes = 3;

    public static void Write(Stream stream, SoftwareBitmap bitmap)
    {
        var pixels = PngWriter.PlainPixels(bitmap);
        foreach (var pixel in pixels)
        {
            if (pixel >> 24 != 0xFF) throw new ArgumentException("Only a picture without transparent pixels is written by palette.", nameof(bitmap));
        }

        var palette = ColourPalette.From(pixels);
        stream.Write(PngChunk.Signature);
        PngChunk.Write(stream, "IHDR"u8, PngWriter.Header(bitmap, PngColorType.Palette));
        PngChunk.Write(stream, "pHYs"u8, PngWriter.Resolution(bitmap));
        PngChunk.Write(stream, "PLTE"u8, Bytes(palette));
        PngChunk.Write(stream, "IDAT"u8, CompressedRows(pixels, bitmap.PixelSize.Width, palette));
        PngChunk.Write(stream, "IEND"u8, []);
    }

    private static byte[] Bytes(ColourPalette palette)
    {
        var bytes = new byte[palette.Colours.Count * ColourBytes];
        for (var i = 0; i < bytes.Length; i++) bytes[i] = (byte)(palette.Colours[i / ColourBytes] >> (8 * (i % ColourBytes)));
        return bytes;
    }

    private static byte[] CompressedRows(uint[] pixels, int width, ColourPalette palette)
    {
        using var memory = new MemoryStream();
        using (var compressor = new ZLibStream(memory, CompressionLevel.SmallestSize, leaveOpen: true))
        {
            var line = new byte[width + 1]; // its first byte is 0, no row filter: differences of palette indices mean nothing
            for (var from = 0; from < pixels.Length; from += width)
            {
                for (var x = 0; x < width; x++) line[x + 1] = palette.PlaceOf(pixels[from + x]);
                compressor.Write(line);
            }
        }

        return memory.ToArray();
    }
}
