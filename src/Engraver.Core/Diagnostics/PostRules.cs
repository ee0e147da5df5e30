namespace Engraver.Core.Diagnostics;

/// <summary>The findings of posts and of the readers of posted programs. Lengths in the sentences are millimetres, lines those of the program's file.</summary>
public static class PostRules
{
    public static readonly DiagnosticRule BlockUnreadable = new("PST0001", Severity.Error, "line", "reason");

    public static readonly DiagnosticRule ProgramParted = new("PST0002", Severity.Warning, "blocks", "most", "parts");

    public static readonly DiagnosticRule TooManyBlocks = new("PST0003", Severity.Error, "most");

    public static readonly DiagnosticRule ContourError = new("PST0004", Severity.Warning, "error", "x", "y", "block", "closure");

    public static readonly DiagnosticRule RadiusNotWritable = new("PST0005", Severity.Error, "largest");

    public static readonly DiagnosticRule NothingToMove = new("PST0006", Severity.Error);

    public static readonly DiagnosticRule NotInDialect = new("PST0010", Severity.Error, "dialect", "option");

    public static readonly DiagnosticRule PlaceNotWritable = new("PST0011", Severity.Error, "x", "y", "largest");

    public static readonly DiagnosticRule Rounded = new("PST0012", Severity.Info, "unit", "error", "x", "y");

    public static readonly DiagnosticRule ToolAndSpindle = new("PST0013", Severity.Error);

    public static readonly DiagnosticRule NotFinite = new("PST0014", Severity.Error, "entity");

    /// <summary>Every rule, for the documentation and its test.</summary>
    public static IReadOnlyList<DiagnosticRule> All { get; } = [BlockUnreadable, ProgramParted, TooManyBlocks, ContourError, RadiusNotWritable, NothingToMove, NotInDialect, PlaceNotWritable, Rounded, ToolAndSpindle, NotFinite];
}
