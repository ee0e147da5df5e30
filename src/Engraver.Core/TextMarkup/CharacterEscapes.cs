using System.Globalization;
using System.Text;

namespace Engraver.Core.TextMarkup;

/// <summary>The escapes of characters that are valid in every string of a DXF (DXF reference, "Formatting Conventions"): \U+XXXX and \M+nXXXX.</summary>
public static class CharacterEscapes
{
    private const int UnicodeLength = 7;
    private const int MultiByteLength = 8;
    private static readonly int[] MultiByteCodePages = [932, 950, 949, 1361, 936];

    /// <summary>The text with its escapes replaced by their characters; what is not a valid escape remains.</summary>
    public static string Resolved(string text)
    {
        ArgumentNullException.ThrowIfNull(text);
        var at = Next(text, 0);
        if (at < 0) return text;
        var result = new StringBuilder(text.Length);
        var done = 0;
        for (; at >= 0; at = Next(text, at + 1))
        {
            var length = LengthAt(text, at, out var meant);
            if (length == 0) continue;
            result.Append(text, done, at - done).Append(meant);
            done = at + length;
        }

        return result.Append(text, done, text.Length - done).ToString();
    }

    /// <summary>Length of the escape that begins at a backslash, and its characters; 0 when none begins there.</summary>
    internal static int LengthAt(string text, int at, out string meant)
    {
        meant = "";
        if (!MayBegin(text, at)) return 0;
        return text[at + 1] is 'U' or 'u' ? Unicode(text.AsSpan(at), out meant) : MultiByte(text.AsSpan(at), out meant);
    }

    /// <summary>The character of a code page of Windows; U+FFFD for a byte without one.</summary>
    internal static string OfByte(byte value, int codePage) => CodePagesEncodingProvider.Instance.GetEncoding(codePage)?.GetString([value]) ?? "\uFFFD";

    /// <summary>Index of the next \U+ or \M+; -1 when there is none.</summary>
    private static int Next(string text, int from)
    {
        for (var at = text.IndexOf('\\', from); at >= 0; at = text.IndexOf('\\', at + 1))
        {
            if (MayBegin(text, at)) return at;
        }

        return -1;
    }

    private static bool MayBegin(string text, int at) => at + 2 < text.Length && text[at + 2] == '+' && text[at + 1] is 'U' or 'u' or 'M' or 'm';

    /// <summary>\U+XXXX: a UTF-16 unit.</summary>
    private static int Unicode(ReadOnlySpan<char> text, out string meant)
    {
        meant = "";
        if (text.Length < UnicodeLength || !ushort.TryParse(text.Slice(3, 4), NumberStyles.AllowHexSpecifier, CultureInfo.InvariantCulture, out var unit)) return 0;
        meant = ((char)unit).ToString();
        return UnicodeLength;
    }

    /// <summary>\M+nXXXX: two bytes in Shift-JIS (1), Big5 (2), Korean (3), Johab (4) or GBK (5).</summary>
    private static int MultiByte(ReadOnlySpan<char> text, out string meant)
    {
        meant = "";
        if (text.Length < MultiByteLength || text[3] is < '1' or > '5' || !ushort.TryParse(text.Slice(4, 4), NumberStyles.AllowHexSpecifier, CultureInfo.InvariantCulture, out var pair)) return 0;
        if (CodePagesEncodingProvider.Instance.GetEncoding(MultiByteCodePages[text[3] - '1']) is not { } codePage) return 0;
        meant = codePage.GetString(pair > byte.MaxValue ? [(byte)(pair >> 8), (byte)pair] : [(byte)pair]);
        return MultiByteLength;
    }
}
