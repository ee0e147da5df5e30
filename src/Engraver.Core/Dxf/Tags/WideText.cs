using System.Text;

namespace Engraver.Core.Dxf.Tags;

/// <summary>UTF-16, as some editors save a DXF: recognised by a byte order mark, or by every other byte being zero.</summary>
internal static class WideText
{
    /// <summary>The same text in UTF-8; null when the file is not UTF-16.</summary>
    public static byte[]? ToUtf8(ReadOnlySpan<byte> file)
    {
        if (EncodingOf(file) is not { } encoding) return null;
        var text = encoding.GetString(file).TrimStart('\uFEFF');
        return Encoding.UTF8.GetBytes(text);
    }

    private static UnicodeEncoding? EncodingOf(ReadOnlySpan<byte> file) => file switch
    {
        [0xFF, 0xFE, ..] => new UnicodeEncoding(bigEndian: false, byteOrderMark: false),
        [0xFE, 0xFF, ..] => new UnicodeEncoding(bigEndian: true, byteOrderMark: false),
        [not 0, 0, not 0, 0, ..] => new UnicodeEncoding(bigEndian: false, byteOrderMark: false),
        [0, not 0, 0, not 0, ..] => new UnicodeEncoding(bigEndian: true, byteOrderMark: false),
        _ => null,
    };
}
