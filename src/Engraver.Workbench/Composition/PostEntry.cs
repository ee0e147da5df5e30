using Engraver.Core.Posts;

namespace Engraver.Workbench.Composition;

/// <summary>One format.</summary>
/// <param name="Keyword">Keyword at POST; the capitals are its abbreviation.</param>
/// <param name="Reader">Reader used by <c>verify</c>; null if there is none.</param>
public sealed record PostEntry(IPost Post, string Keyword, IProgramReader? Reader = null)
{
    /// <summary>Key of the controller family whose controllers run it; null for a program that this workbench only writes.</summary>
    public string? Controller { get; init; }

    /// <summary>Readers by dialect; empty if there is only one.</summary>
    public IReadOnlyDictionary<string, IProgramReader> Dialects { get; init; } = new Dictionary<string, IProgramReader>();

    /// <summary>The non-default dialects, by their keywords at prompts.</summary>
    public IReadOnlyDictionary<string, string> OtherDialects { get; init; } = new Dictionary<string, string>();
}
