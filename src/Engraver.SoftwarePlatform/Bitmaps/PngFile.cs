namespace Engraver.SoftwarePlatform.Bitmaps;

/// <summary>Portable Network Graphics, in and out (ISO/IEC 15948).</summary>
public static class PngFile
{
    /// <summary>Writes 8 bits for each of red, green, blue and alpha.</summary>
    public static void Write(Stream stream, SoftwareBitmap bitmap)
    {
        ArgumentNullException.ThrowIfNull(stream);
        ArgumentNullException.ThrowIfNull(bitmap);
        PngWriter.Write(stream, bitmap);
    }

    /// <summary>Writes at most 256 colours, one byte a pixel: a third of the size of a window's picture. Rare colours are shown by their nearest.</summary>
    /// <exception cref="ArgumentException">A pixel is transparent.</exception>
    public static void WriteIndexed(Stream stream, SoftwareBitmap bitmap)
    {
        ArgumentNullException.ThrowIfNull(stream);
        ArgumentNullException.ThrowIfNull(bitmap);
        IndexedPngWriter.Write(stream, bitmap);
    }

    /// <summary>Reads every colour type and bit depth, interlaced or not. A file without a resolution has 96 dots per inch.</summary>
    /// <exception cref="InvalidDataException">The stream is no PNG file, or a broken one.</exception>
    public static SoftwareBitmap Read(Stream stream)
    {
        ArgumentNullException.ThrowIfNull(stream);
        using var memory = new MemoryStream();
        stream.CopyTo(memory);
        return PngReader.Read(memory.ToArray());
    }
}
