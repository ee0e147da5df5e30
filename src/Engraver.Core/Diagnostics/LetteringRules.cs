namespace Engraver.Core.Diagnostics;

/// <summary>The findings of texts that are cut.</summary>
public static class LetteringRules
{
    public static readonly DiagnosticRule FontMissing = new("TXT0001", Severity.Warning, "font", "substitute");

    public static readonly DiagnosticRule FontMapped = new("TXT0002", Severity.Info, "font", "substitute");

    public static readonly DiagnosticRule FontBroken = new("TXT0003", Severity.Warning, "font", "substitute");

    public static readonly DiagnosticRule GlyphSubstituted = new("TXT0004", Severity.Warning, "characters", "count");

    public static readonly DiagnosticRule GlyphMissing = new("TXT0005", Severity.Error, "characters", "count");

    public static readonly DiagnosticRule GlyphBroken = new("TXT0006", Severity.Warning, "characters", "count");

    public static readonly DiagnosticRule UnknownCode = new("TXT0007", Severity.Warning, "codes", "count");

    public static readonly DiagnosticRule FormIgnored = new("TXT0008", Severity.Warning, "forms", "count");

    public static readonly DiagnosticRule Unshaped = new("TXT0009", Severity.Error, "characters", "count");

    public static readonly DiagnosticRule NoSize = new("TXT0010", Severity.Error, "text");

    public static readonly DiagnosticRule OutOfRange = new("TXT0011", Severity.Error, "text");

    public static readonly DiagnosticRule Tilted = new("TXT0012", Severity.Warning, "count");

    public static readonly DiagnosticRule SubstitutesUnreadable = new("TXT0013", Severity.Warning, "line", "file");

    public static readonly DiagnosticRule NotUnited = new("TXT0014", Severity.Warning, "text");

    public static readonly DiagnosticRule Damaged = new("TXT0015", Severity.Error, "text", "group");

    /// <summary>Every rule, for the documentation and its test.</summary>
    public static IReadOnlyList<DiagnosticRule> All { get; } = [FontMissing, FontMapped, FontBroken, GlyphSubstituted, GlyphMissing, GlyphBroken, UnknownCode, FormIgnored, Unshaped, NoSize, OutOfRange, Tilted, SubstitutesUnreadable, NotUnited, Damaged];
}
