using Engraver.Workbench.Files;

namespace Engraver.Workbench.CommandLanguage;

/// <summary>The files that fit a prompt.</summary>
/// <param name="Kind">Kind of file, an internal key (<c>drawing</c>, <c>script</c>); the last folder is remembered for each.</param>
/// <param name="Writes">The file is written and need not exist.</param>
/// <param name="Extensions">File extensions with their dots, the default first; empty if every file fits.</param>
public sealed record FileRequest(string Kind, bool Writes, params IReadOnlyList<string> Extensions)
{
    public const string Drawing = "drawing";

    /// <summary>Full path suggested by a dialog; null for none.</summary>
    public string? Suggested { get; init; }

    /// <summary>Enter alone is allowed: the result is shown in the command window and not written.</summary>
    public bool CanDisplayInstead { get; init; }

    /// <summary>The name with the default extension, unless it already has a matching one or is a stream.</summary>
    public string WithExtension(string name)
    {
        ArgumentNullException.ThrowIfNull(name);
        return Extensions.Count == 0 || Matches(name) || Path.EndsInDirectorySeparator(name) || FileKind.IsStream(name) ? name : name.TrimEnd('.') + Extensions[0];
    }

    /// <summary>True for a file with one of the extensions.</summary>
    public bool Matches(string name) => Extensions.Count == 0 || Extensions.Any(ending => name.EndsWith(ending, StringComparison.OrdinalIgnoreCase));
}
