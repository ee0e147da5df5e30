namespace Engraver.Core.Dxf.Tags;

/// <summary>Recognises files that are often given in place of a DXF by their first bytes.</summary>
internal static class ForeignFile
{
    private const int MarkupStart = 1024;

    private static readonly (byte[] Beginning, string TextName)[] Known =
    [
        ([.. "AutoCAD DXB 1.0\r\n\u001A\0"u8], "ForeignFile.Dxb"),
        ([.. "%PDF"u8], "ForeignFile.Pdf"),
        ([.. "%!PS"u8], "ForeignFile.PostScript"),
        ([0x50, 0x4B, 0x03, 0x04], "ForeignFile.Zip"),
        ([0x1F, 0x8B, 0x08], "ForeignFile.Gzip"),
        ([.. "BZh"u8], "ForeignFile.Bzip2"),
        ([0xFD, 0x37, 0x7A, 0x58, 0x5A, 0x00], "ForeignFile.Xz"),
        ([0x37, 0x7A, 0xBC, 0xAF, 0x27, 0x1C], "ForeignFile.SevenZip"),
        ([.. "Rar!"u8], "ForeignFile.Rar"),
        ([0xD0, 0xCF, 0x11, 0xE0, 0xA1, 0xB1, 0x1A, 0xE1], "ForeignFile.Office"),
        ([0x89, 0x50, 0x4E, 0x47], "ForeignFile.Png"),
        ([0xFF, 0xD8, 0xFF], "ForeignFile.Jpeg"),
        ([.. "GIF8"u8], "ForeignFile.Gif"),
        ([.. "(DWF V"u8], "ForeignFile.Dwf"),
        ([.. "ISO-10303-21;"u8], "ForeignFile.Step"),
        ([.. "solid "u8], "ForeignFile.Stl"),
    ];

    /// <summary>The kind of the file, with its article; null when it is unknown.</summary>
    public static string? NameOf(ReadOnlySpan<byte> file)
    {
        foreach (var (beginning, name) in Known)
        {
            if (file.StartsWith(beginning)) return Wording.Get(name);
        }

        var text = (file.StartsWith("\uFEFF"u8) ? file[3..] : file).TrimStart(" \t\r\n"u8);
        if (text.IsEmpty || text[0] != '<') return null;
        var start = text[..Math.Min(MarkupStart, text.Length)];
        if (start.IndexOf("<svg"u8) >= 0) return Wording.Get("ForeignFile.SvgDrawing");
        return start.IndexOf("<html"u8) >= 0 || start.IndexOf("<!DOCTYPE html"u8) >= 0 || start.IndexOf("<!doctype html"u8) >= 0 ? Wording.Get("ForeignFile.WebPage") : Wording.Get("ForeignFile.XmlFile");
    }
}
