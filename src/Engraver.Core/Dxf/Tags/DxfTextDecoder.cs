using System.Globalization;
using System.Text;

namespace Engraver.Core.Dxf.Tags;

/// <summary>Decodes names: UTF-8 from AC1021 on, before that the code page that $DWGCODEPAGE names; \U+XXXX escapes are resolved.</summary>
internal sealed class DxfTextDecoder
{
    private static readonly int[] MultiByteCodePages = [932, 950, 949, 1361, 936];
    private static readonly Encoding StrictUtf8 = new UTF8Encoding(false, throwOnInvalidBytes: true);
    private bool _utf8;
    private bool _forced;
    private Encoding? _codePage;

    /// <summary>True after a name was not valid in the encoding that the file declares.</summary>
    public bool MetForeignBytes { get; private set; }

    /// <summary>Takes $ACADVER; releases from 2007 write UTF-8.</summary>
    public void UseVersion(string version) =>
        _utf8 = version.Length == 6 && version.StartsWith("AC", StringComparison.OrdinalIgnoreCase)
            && int.TryParse(version.AsSpan(2), NumberStyles.None, CultureInfo.InvariantCulture, out var number) && number >= 1021;

    /// <summary>Sets UTF-8 (the file was UTF-16, or begins with a byte order mark), whatever the header states.</summary>
    public void UseUtf8() => _forced = true;

    /// <summary>Takes $DWGCODEPAGE; false when the name is not known (Windows-1252 is used then).</summary>
    public bool UseCodePage(string name)
    {
        _codePage = CodePageNumber(name) is { } number ? Find(number) : null;
        return _codePage is not null;
    }

    public string Decode(ReadOnlySpan<byte> bytes)
    {
        if (Ascii.IsValid(bytes)) return Unescape(Encoding.ASCII.GetString(bytes));
        var validUtf8 = System.Text.Unicode.Utf8.IsValid(bytes);
        if (_forced && validUtf8) return Unescape(StrictUtf8.GetString(bytes));
        var codePage = _codePage ?? Find(1252) ?? Encoding.Latin1;
        // Text in a single-byte code page is practically never valid UTF-8 by chance; a file that declares 1252 and contains UTF-8 is common.
        var readAsUtf8 = validUtf8 && (_utf8 || _codePage is null || codePage.IsSingleByte);
        MetForeignBytes |= _utf8 ? !validUtf8 : _codePage is not null && readAsUtf8;
        return Unescape((readAsUtf8 ? StrictUtf8 : codePage).GetString(bytes));
    }

    private static Encoding? Find(int codePage) => codePage == Encoding.UTF8.CodePage ? Encoding.UTF8
        : codePage == Encoding.Latin1.CodePage ? Encoding.Latin1
        : CodePagesEncodingProvider.Instance.GetEncoding(codePage);

    /// <summary>The number in names such as ANSI_1252, ansi_936, DOS437, ISO8859-2 and GB2312.</summary>
    private static int? CodePageNumber(string name)
    {
        var upper = name.Trim().ToUpperInvariant();
        int? known = upper switch
        {
            "GB2312" or "GBK" => 936,
            "BIG5" => 950,
            "KSC5601" => 949,
            "JOHAB" => 1361,
            "GB18030" => 54936,
            "TIS-620" or "TIS620" or "ISO8859-11" => 874,
            "MACINTOSH" or "MAC-ROMAN" => 10000,
            "UTF-8" or "UTF8" => 65001,
            "ASCII" or "ISO8859-1" => 28591,
            "UNDEFINED" or "" => 1252,
            _ => null,
        };
        if (known is not null) return known;
        var digits = upper.AsSpan(upper.AsSpan().TrimEnd("0123456789").Length);
        if (!int.TryParse(digits, NumberStyles.None, CultureInfo.InvariantCulture, out var number)) return null;
        return upper.StartsWith("ISO8859", StringComparison.Ordinal) ? 28590 + number : number;
    }

    private static string Unescape(string text)
    {
        var at = NextEscape(text, 0);
        if (at < 0) return text;
        var result = new StringBuilder(text.Length);
        var done = 0;
        for (; at >= 0; at = NextEscape(text, at + 1))
        {
            var length = text[at + 1] is 'U' or 'u' ? UnicodeEscape(text.AsSpan(at), out var meant) : MultiByteEscape(text.AsSpan(at), out meant);
            if (length == 0) continue;
            result.Append(text, done, at - done).Append(meant);
            done = at + length;
        }

        return result.Append(text, done, text.Length - done).ToString();
    }

    /// <summary>Index of the next \U+ or \M+; -1 when there is none.</summary>
    private static int NextEscape(string text, int from)
    {
        for (var at = text.IndexOf('\\', from); at >= 0; at = text.IndexOf('\\', at + 1))
        {
            if (at + 2 < text.Length && text[at + 2] == '+' && text[at + 1] is 'U' or 'u' or 'M' or 'm') return at;
        }

        return -1;
    }

    /// <summary>\U+XXXX: a UTF-16 unit.</summary>
    private static int UnicodeEscape(ReadOnlySpan<char> text, out string meant)
    {
        meant = "";
        if (text.Length < 7 || !ushort.TryParse(text.Slice(3, 4), NumberStyles.AllowHexSpecifier, CultureInfo.InvariantCulture, out var unit)) return 0;
        meant = ((char)unit).ToString();
        return 7;
    }

    /// <summary>\M+nXXXX: two bytes in Shift-JIS (1), Big5 (2), Korean (3), Johab (4) or GBK (5).</summary>
    private static int MultiByteEscape(ReadOnlySpan<char> text, out string meant)
    {
        meant = "";
        if (text.Length < 8 || text[3] is < '1' or > '5' || !ushort.TryParse(text.Slice(4, 4), NumberStyles.AllowHexSpecifier, CultureInfo.InvariantCulture, out var pair)) return 0;
        if (Find(MultiByteCodePages[text[3] - '1']) is not { } codePage) return 0;
        meant = codePage.GetString(pair > byte.MaxValue ? [(byte)(pair >> 8), (byte)pair] : [(byte)pair]);
        return 8;
    }
}
