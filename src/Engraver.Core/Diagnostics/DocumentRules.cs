namespace Engraver.Core.Diagnostics;

/// <summary>Findings about a file as a whole, before its content is read.</summary>
public static class DocumentRules
{
    public static readonly DiagnosticRule Unreadable = new("DOC0001", Severity.Error, "reason");

    public static readonly DiagnosticRule NothingToPost = new("DOC0002", Severity.Error);

    public static readonly DiagnosticRule NotSaved = new("DOC0003", Severity.Warning, "count", "types");

    public static IReadOnlyList<DiagnosticRule> All { get; } = [Unreadable, NothingToPost, NotSaved];
}
