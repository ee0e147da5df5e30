using Engraver.Core.Diagnostics;
using Engraver.Core.Languages;

namespace Engraver.Workbench.SerialTexts;

/// <summary>A CSV file: a header and rows of as many values (RFC 4180). The separator is the comma, the semicolon or the tab that the header has most
/// often.</summary>
/// <param name="Columns">The header.</param>
/// <param name="Rows">Numbered from 1.</param>
public sealed record CsvTable(IReadOnlyList<string> Columns, IReadOnlyList<CsvRow> Rows)
{
    /// <summary>A file of names is not larger than this, bytes.</summary>
    private const int MaxBytes = 64 << 20;

    /// <returns>The table, or null where a finding is an error. The line of a finding is the line of the file.</returns>
    public static (CsvTable? Table, IReadOnlyList<Diagnostic> Findings) Read(string path)
    {
        try
        {
            if (new FileInfo(path).Length > MaxBytes) return (null, [SerialRules.CsvUnreadable.At(default, Wording.Get("Serial.CsvTooLarge", MaxBytes >> 20))]);
            return Read(File.ReadAllBytes(path));
        }
        catch (Exception unreadable) when (unreadable is IOException or UnauthorizedAccessException or ArgumentException)
        {
            return (null, [SerialRules.CsvUnreadable.At(default, SystemErrorText.FromException(unreadable))]);
        }
    }

    /// <returns>As for the file.</returns>
    public static (CsvTable? Table, IReadOnlyList<Diagnostic> Findings) Read(byte[] bytes)
    {
        var (text, isWestern) = CsvText.Decode(bytes);
        if (text.Contains('\0', StringComparison.Ordinal)) return (null, [SerialRules.CsvUnreadable.At(default, Wording.Get("Serial.CsvNotText"))]);
        List<Diagnostic> findings = isWestern ? [SerialRules.CsvWestern.At(default)] : [];
        var records = CsvText.Records(text, findings);
        if (records.Count == 0)
        {
            findings.Add(SerialRules.CsvEmpty.At(default));
            return (null, findings);
        }

        var columns = records[0].Values.Select(name => name.Trim()).ToList();
        findings.AddRange(HeaderFindings(columns, records[0].Line));
        var rows = RowsOf(columns, records.Skip(1), findings);
        if (rows.Count == 0) findings.Add(SerialRules.CsvEmpty.At(new SourceRef(records[0].Line)));
        return (findings.Exists(finding => finding.Severity == Severity.Error) ? null : new CsvTable(columns, rows), findings);
    }

    private static IEnumerable<Diagnostic> HeaderFindings(List<string> columns, int line)
    {
        for (var i = 0; i < columns.Count; i++)
        {
            var name = columns[i];
            if (name.Length == 0) yield return SerialRules.CsvNoColumnName.At(new SourceRef(line), Invariant(i + 1));
            else if (columns.FindIndex(one => one.Equals(name, StringComparison.OrdinalIgnoreCase)) < i) yield return SerialRules.CsvColumnTwice.At(new SourceRef(line), name);
        }
    }

    private static List<CsvRow> RowsOf(List<string> columns, IEnumerable<CsvRecord> records, List<Diagnostic> findings)
    {
        var (rows, emptyLine) = (new List<CsvRow>(), 0);
        foreach (var record in records)
        {
            if (record.IsEmpty)
            {
                emptyLine = emptyLine == 0 ? record.Line : emptyLine;
                continue;
            }

            if (emptyLine > 0) findings.Add(SerialRules.CsvEmptyLine.At(new SourceRef(emptyLine))); // empty lines at the end of the file are usual
            emptyLine = 0;
            if (record.Values.Count != columns.Count) findings.Add(SerialRules.CsvRowLength.At(new SourceRef(record.Line), Invariant(record.Values.Count), Invariant(columns.Count)));
            else rows.Add(new CsvRow(rows.Count + 1, [.. columns.Zip(record.Values, (column, value) => new CsvValue(column, value))]));
        }

        return rows;
    }

    private static string Invariant(int number) => FactText.Of(number);
}
