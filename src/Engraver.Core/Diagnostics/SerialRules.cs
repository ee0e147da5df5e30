namespace Engraver.Core.Diagnostics;

/// <summary>Findings about the fields of texts, the CSV file that fills them, and the counters.</summary>
public static class SerialRules
{
    public static readonly DiagnosticRule InvalidField = new("SER0001", Severity.Error, "field", "reason");

    public static readonly DiagnosticRule NoValue = new("SER0002", Severity.Error, "field", "reason");

    public static readonly DiagnosticRule NotAField = new("SER0003", Severity.Warning, "text");

    public static readonly DiagnosticRule TwoDesigns = new("SER0004", Severity.Error, "counter", "field");

    public static readonly DiagnosticRule CsvUnused = new("SER0005", Severity.Error, "columns");

    public static readonly DiagnosticRule CsvUnreadable = new("SER0010", Severity.Error, "reason");

    public static readonly DiagnosticRule CsvWestern = new("SER0011", Severity.Warning);

    public static readonly DiagnosticRule CsvColumnTwice = new("SER0012", Severity.Error, "column");

    public static readonly DiagnosticRule CsvNoColumnName = new("SER0013", Severity.Error, "number");

    public static readonly DiagnosticRule CsvRowLength = new("SER0014", Severity.Error, "values", "columns");

    public static readonly DiagnosticRule CsvEmptyLine = new("SER0015", Severity.Warning);

    public static readonly DiagnosticRule CsvQuote = new("SER0016", Severity.Error, "reason");

    public static readonly DiagnosticRule CsvEmpty = new("SER0017", Severity.Error);

    public static readonly DiagnosticRule CsvNoSuchRow = new("SER0018", Severity.Error, "rows", "count");

    public static readonly DiagnosticRule CountersUnreadable = new("SER0020", Severity.Error, "file", "reason");

    public static readonly DiagnosticRule CountersNotWritten = new("SER0021", Severity.Error, "file", "reason");

    public static readonly DiagnosticRule PlateNotFinished = new("SER0022", Severity.Error, "values", "drawing", "date", "journal");

    public static readonly DiagnosticRule CounterMoved = new("SER0023", Severity.Error, "counter", "number", "next");

    public static readonly DiagnosticRule NumberNotOpen = new("SER0024", Severity.Error, "counter", "number");

    public static readonly DiagnosticRule CounterSetBack = new("SER0025", Severity.Warning, "counter", "next", "value");

    public static readonly DiagnosticRule NotConfirmed = new("SER0026", Severity.Warning, "values", "reason");

    public static readonly DiagnosticRule CounterExhausted = new("SER0027", Severity.Error, "counter", "number");

    /// <summary>Every rule of this table, in order of id.</summary>
    public static IReadOnlyList<DiagnosticRule> All { get; } = [InvalidField, NoValue, NotAField, TwoDesigns, CsvUnused, CsvUnreadable, CsvWestern, CsvColumnTwice, CsvNoColumnName, CsvRowLength, CsvEmptyLine, CsvQuote, CsvEmpty, CsvNoSuchRow, CountersUnreadable, CountersNotWritten, PlateNotFinished, CounterMoved, NumberNotOpen, CounterSetBack, NotConfirmed, CounterExhausted];
}
