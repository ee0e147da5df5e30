namespace Engraver.SoftwarePlatform.Bitmaps;

/// <summary>Reads and writes Portable Network Graphics (ISO/IEC 15948).</summary>
public static class PngFile
{
    /// <summary>Writes 8 bits for each of red, green, blue and alpha.</summary>
    public static void Write(Stream stream, SoftwareBitmap bitmap)
    {
        ArgumentNullException.ThrowIfNull(stream);
        ArgumentNullException.ThrowIfNull(bitmap);
        PngWriter.Write(stream, bitmap);
    }

    /// <summary>Writes at most 256 colours, one byte per pixel: a third of the size for a window's picture. Rare colours are replaced by the nearest of the
    /// palette.</summary>
    /// <exception cref="ArgumentException">A pixel is transparent.</exception>
    public static void WriteIndexed(Stream stream, SoftwareBitmap bitmap)
    {
        ArgumentNullException.ThrowIfNull(stream);
        ArgumentNullException.ThrowIfNull(bitmap);
        IndexedPngWriter.Write(stream, bitmap);
    }

    /// <summary>Reads every colour type and bit depth, interlaced or not. A file without a resolution has 96 dots per inch.</summary>
    /// <exception cref="InvalidDataException">The stream is not a PNG file, or a damaged one.</exception>
    public static SoftwareBitmap Read(Stream stream)
    {
        ArgumentNullException.ThrowIfNull(stream);
        using var memory = new MemoryStream();
        stream.CopyTo(memory);
        return PngReader.Read(memory.ToArray());
    }
}
