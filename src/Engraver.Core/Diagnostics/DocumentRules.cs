namespace Engraver.Core.Diagnostics;

/// <summary>Findings about a file as a file, before anything in it is read.</summary>
public static class DocumentRules
{
    public static readonly DiagnosticRule Unreadable = new(
        "DOC0001",
        Severity.Error,
        "The file cannot be opened: {reason}.",
        "Check the name and the right to read it.");

    public static readonly DiagnosticRule NothingToPost = new(
        "DOC0002",
        Severity.Error,
        "There is nothing to post: no curve of the drawing is cut.",
        "Look at the drawing with [look]; name layers with [layers], or have construction cut with [cut].");

    public static readonly DiagnosticRule NotSaved = new(
        "DOC0003",
        Severity.Warning,
        "{count} records are not written, because a drawing holds only curves and texts: {types}.",
        "Keep the original file.");

    public static IReadOnlyList<DiagnosticRule> All { get; } = [Unreadable, NothingToPost, NotSaved];
}
