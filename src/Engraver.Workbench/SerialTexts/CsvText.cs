using System.Text;
using Engraver.Core.Diagnostics;

namespace Engraver.Workbench.SerialTexts;

/// <summary>The characters and the records of a CSV file.</summary>
internal static class CsvText
{
    private const int WesternCodePage = 1252;
    private const string SeparatorLine = "sep=";

    /// <summary>UTF-8, with or without its mark, or UTF-16 with its mark; otherwise code page 1252.</summary>
    public static (string Text, bool IsWestern) Decode(byte[] bytes)
    {
        ArgumentNullException.ThrowIfNull(bytes);
        Encoding[] marked = [new UTF8Encoding(true, throwOnInvalidBytes: true), new UnicodeEncoding(bigEndian: false, byteOrderMark: true, throwOnInvalidBytes: true), new UnicodeEncoding(bigEndian: true, byteOrderMark: true, throwOnInvalidBytes: true)];
        var mark = Array.Find(marked, one => bytes.AsSpan().StartsWith(one.Preamble));
        try
        {
            return (mark is null ? marked[0].GetString(bytes) : mark.GetString(bytes.AsSpan(mark.Preamble.Length)), false);
        }
        catch (DecoderFallbackException)
        {
            return (CodePagesEncodingProvider.Instance.GetEncoding(WesternCodePage)!.GetString(bytes), true);
        }
    }

    /// <summary>The records with their lines. A first line <c>sep=;</c>, which spreadsheets write, states the separator and is not a record.</summary>
    public static IReadOnlyList<CsvRecord> Records(string text, List<Diagnostic> findings)
    {
        var (at, line, separator) = (0, 1, default(char?));
        if (text.StartsWith(SeparatorLine, StringComparison.OrdinalIgnoreCase) && text.Length > SeparatorLine.Length && EndOfLine(text, SeparatorLine.Length + 1) is { } end)
        {
            (at, line, separator) = (end, 2, text[SeparatorLine.Length]);
        }

        var records = new List<CsvRecord>();
        separator ??= SeparatorOf(text);
        while (at < text.Length)
        {
            var record = Record(text, separator.Value, ref at, ref line, findings);
            if (records.Count > 0 || !record.IsEmpty) records.Add(record); // empty lines before the header
        }

        return records;
    }

    /// <summary>The separator that the first line that is not empty has most often outside quotes.</summary>
    private static char SeparatorOf(string text)
    {
        var counts = new Dictionary<char, int> { [','] = 0, [';'] = 0, ['\t'] = 0 };
        var isQuoted = false;
        foreach (var letter in text.AsSpan().TrimStart("\r\n"))
        {
            if (letter == '"') isQuoted = !isQuoted;
            else if (!isQuoted && letter is '\r' or '\n') break;
            else if (!isQuoted && counts.TryGetValue(letter, out var count)) counts[letter] = count + 1;
        }

        return counts.MaxBy(one => one.Value).Key;
    }

    private static CsvRecord Record(string text, char separator, ref int at, ref int line, List<Diagnostic> findings)
    {
        var (values, first) = (new List<string>(), line);
        while (true)
        {
            values.Add(at < text.Length && text[at] == '"' ? Quoted(text, separator, ref at, ref line, findings) : Plain(text, separator, ref at));
            if (at >= text.Length) break;
            if (EndOfLine(text, at) is { } end)
            {
                at = end;
                line++;
                break;
            }

            at++; // the separator
        }

        return new CsvRecord(first, values);
    }

    private static string Plain(string text, char separator, ref int at)
    {
        var start = at;
        while (at < text.Length && text[at] != separator && text[at] is not ('\r' or '\n')) at++;
        return text[start..at];
    }

    private static string Quoted(string text, char separator, ref int at, ref int line, List<Diagnostic> findings)
    {
        var (value, opened) = (new StringBuilder(), line);
        for (at++; at < text.Length; at++)
        {
            if (text[at] == '"' && at + 1 < text.Length && text[at + 1] == '"') at++;
            else if (text[at] == '"') return AfterQuote(text, separator, value, ref at, line, findings);
            else if (text[at] == '\n' || (text[at] == '\r' && (at + 1 == text.Length || text[at + 1] != '\n'))) line++;
            value.Append(text[at]);
        }

        findings.Add(SerialRules.CsvQuote.At(new SourceRef(opened), Wording.Get("Serial.QuoteNotClosed")));
        return value.ToString();
    }

    private static string AfterQuote(string text, char separator, StringBuilder value, ref int at, int line, List<Diagnostic> findings)
    {
        at++;
        if (Plain(text, separator, ref at) is { Length: > 0 } rest && rest.Trim().Length > 0) findings.Add(SerialRules.CsvQuote.At(new SourceRef(line), Wording.Get("Serial.TextAfterQuote", rest)));
        return value.ToString();
    }

    /// <summary>Index after a line end; null where there is none.</summary>
    private static int? EndOfLine(string text, int at) => at >= text.Length ? null : text[at] switch
    {
        '\n' => at + 1,
        '\r' => at + 1 < text.Length && text[at + 1] == '\n' ? at + 2 : at + 1,
        _ => null,
    };
}

/// <param name="Line">Its first line in the file.</param>
internal sealed record CsvRecord(int Line, IReadOnlyList<string> Values)
{
    /// <summary>A line without characters.</summary>
    public bool IsEmpty => Values.All(value => value.AsSpan().IsWhiteSpace());
}
