namespace Engraver.Core.Diagnostics;

/// <summary>The findings of sequencing. Lengths in the sentences are millimetres.</summary>
public static class SequencingRules
{
    public static readonly DiagnosticRule DuplicatesRemoved = new("SEQ0001", Severity.Info, "count", "handle");

    public static readonly DiagnosticRule OpenEnds = new("SEQ0002", Severity.Info, "gap", "count", "x", "y");

    public static readonly DiagnosticRule SmallGap = new("SEQ0003", Severity.Warning, "x", "y", "gap", "handle");

    public static readonly DiagnosticRule ShortSegments = new("SEQ0004", Severity.Info, "tolerance", "count", "x", "y");

    public static readonly DiagnosticRule EntryNotFound = new("SEQ0006", Severity.Warning);

    public static readonly DiagnosticRule EntryWaits = new("SEQ0007", Severity.Info, "count");

    public static readonly DiagnosticRule NothingToCut = new("SEQ0008", Severity.Warning);

    public static readonly DiagnosticRule Branches = new("SEQ0009", Severity.Info, "count");

    public static readonly DiagnosticRule ArcRecovered = new("SEQ0010", Severity.Info, "count", "x", "y", "radius", "deviation");

    public static readonly DiagnosticRule CircleRecovered = new("SEQ0011", Severity.Info, "count", "x", "y", "radius", "deviation");

    public static readonly DiagnosticRule EntryStandsIn = new("SEQ0012", Severity.Info, "handle", "other");

    public static readonly DiagnosticRule MoreOfTheSame = new("SEQ0014", Severity.Info, "id", "count", "shown");

    /// <summary>Every rule, for the documentation and its test.</summary>
    public static IReadOnlyList<DiagnosticRule> All { get; } =
        [DuplicatesRemoved, OpenEnds, SmallGap, ShortSegments, EntryNotFound, EntryWaits, NothingToCut, Branches, ArcRecovered, CircleRecovered, EntryStandsIn, MoreOfTheSame];
}
