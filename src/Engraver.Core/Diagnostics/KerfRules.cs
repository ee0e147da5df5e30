namespace Engraver.Core.Diagnostics;

/// <summary>The findings of tool radius compensation. Lengths in the sentences are millimetres.</summary>
public static class KerfRules
{
    public static readonly DiagnosticRule CornerUncut = new("KRF0001", Severity.Warning, "x", "y", "uncut");

    public static readonly DiagnosticRule MoreUncut = new("KRF0002", Severity.Warning, "count", "uncut");

    public static readonly DiagnosticRule TooNarrow = new("KRF0003", Severity.Error, "x", "y", "diameter");

    public static readonly DiagnosticRule OpenOnLine = new("KRF0004", Severity.Warning, "count");

    public static readonly DiagnosticRule NotCompensated = new("KRF0005", Severity.Error, "x", "y");

    public static readonly DiagnosticRule WrongDistance = new("KRF0006", Severity.Error, "x", "y", "off");

    public static readonly DiagnosticRule NotLevel = new("KRF0007", Severity.Error, "x", "y");

    /// <summary>Every rule, for the documentation and its test.</summary>
    public static IReadOnlyList<DiagnosticRule> All { get; } = [CornerUncut, MoreUncut, TooNarrow, OpenOnLine, NotCompensated, WrongDistance, NotLevel];
}
