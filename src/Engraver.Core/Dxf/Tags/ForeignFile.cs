namespace Engraver.Core.Dxf.Tags;

/// <summary>Recognises files that are often given in place of a DXF by their first bytes.</summary>
internal static class ForeignFile
{
    private const int MarkupStart = 1024;

    private static readonly (byte[] Beginning, string Name)[] Known =
    [
        ([.. "AutoCAD DXB 1.0\r\n\u001A\0"u8], "a binary exchange file (DXB)"),
        ([.. "%PDF"u8], "a PDF document"),
        ([.. "%!PS"u8], "a PostScript drawing"),
        ([0x50, 0x4B, 0x03, 0x04], "a ZIP archive (or a document packed in one)"),
        ([0x1F, 0x8B, 0x08], "packed with gzip"),
        ([.. "BZh"u8], "packed with bzip2"),
        ([0xFD, 0x37, 0x7A, 0x58, 0x5A, 0x00], "packed with xz"),
        ([0x37, 0x7A, 0xBC, 0xAF, 0x27, 0x1C], "a 7-Zip archive"),
        ([.. "Rar!"u8], "a RAR archive"),
        ([0xD0, 0xCF, 0x11, 0xE0, 0xA1, 0xB1, 0x1A, 0xE1], "an Office or Visio document"),
        ([0x89, 0x50, 0x4E, 0x47], "a PNG picture"),
        ([0xFF, 0xD8, 0xFF], "a JPEG picture"),
        ([.. "GIF8"u8], "a GIF picture"),
        ([.. "(DWF V"u8], "a DWF drawing"),
        ([.. "ISO-10303-21;"u8], "a STEP model"),
        ([.. "solid "u8], "an STL model"),
    ];

    /// <summary>What the file is, with its article; null when it is unknown.</summary>
    public static string? NameOf(ReadOnlySpan<byte> file)
    {
        foreach (var (beginning, name) in Known)
        {
            if (file.StartsWith(beginning)) return name;
        }

        var text = (file.StartsWith("\uFEFF"u8) ? file[3..] : file).TrimStart(" \t\r\n"u8);
        if (text.IsEmpty || text[0] != '<') return null;
        var start = text[..Math.Min(MarkupStart, text.Length)];
        if (start.IndexOf("<svg"u8) >= 0) return "an SVG drawing";
        return start.IndexOf("<html"u8) >= 0 || start.IndexOf("<!DOCTYPE html"u8) >= 0 || start.IndexOf("<!doctype html"u8) >= 0 ? "a web page" : "an XML file";
    }
}
