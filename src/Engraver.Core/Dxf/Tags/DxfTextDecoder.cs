using System.Globalization;
using System.Text;
using Engraver.Core.TextMarkup;

namespace Engraver.Core.Dxf.Tags;

/// <summary>Decodes names: UTF-8 from AC1021 on, before that the code page that $DWGCODEPAGE names; \U+XXXX escapes are resolved.</summary>
internal sealed class DxfTextDecoder
{
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

    /// <summary>The text with its escapes resolved.</summary>
    public string Decode(ReadOnlySpan<byte> bytes) => CharacterEscapes.Resolved(DecodeRaw(bytes));

    /// <summary>The text as written, with its escapes.</summary>
    public string DecodeRaw(ReadOnlySpan<byte> bytes)
    {
        if (Ascii.IsValid(bytes)) return Encoding.ASCII.GetString(bytes);
        var validUtf8 = System.Text.Unicode.Utf8.IsValid(bytes);
        if (_forced && validUtf8) return StrictUtf8.GetString(bytes);
        var codePage = _codePage ?? Find(1252) ?? Encoding.Latin1;
        // Text in a single-byte code page is practically never valid UTF-8 by chance; a file that declares 1252 and contains UTF-8 is common.
        var readAsUtf8 = validUtf8 && (_utf8 || _codePage is null || codePage.IsSingleByte);
        MetForeignBytes |= _utf8 ? !validUtf8 : _codePage is not null && readAsUtf8;
        return (readAsUtf8 ? StrictUtf8 : codePage).GetString(bytes);
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
}
