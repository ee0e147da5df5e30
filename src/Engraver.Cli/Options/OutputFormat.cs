namespace Engraver.Cli.Options;

/// <summary>Refuses an output file whose name asks for a format that the verb does not write: SVG in a file called .png opens nowhere.</summary>
internal static class OutputFormat
{
    /// <summary>Extensions that name a format of drawings, pictures or pages; with any other name the verb writes what it writes.</summary>
    private static readonly string[] s_formats = [".bmp", ".csv", ".dwg", ".dxf", ".gif", ".htm", ".html", ".jpeg", ".jpg", ".json", ".pdf", ".png", ".svg", ".tif", ".tiff", ".webp"];

    /// <param name="path">Null for standard output.</param>
    /// <param name="written">The extensions of what the verb writes, the usual one first.</param>
    /// <exception cref="UsageException">The name asks for another format.</exception>
    public static void Check(string? path, params string[] written)
    {
        var extension = Path.GetExtension(path ?? "").ToLowerInvariant();
        if (s_formats.Contains(extension) && !written.Contains(extension)) throw new UsageException(Wording.Get("OutputFormat.NotSupported", path, extension, written[0]));
    }
}
