using Engraver.Core.Posts;

namespace Engraver.Workbench.Composition;

/// <summary>A format in one dialect.</summary>
/// <param name="Keyword">Keyword at prompts; the capitals are its abbreviation.</param>
/// <param name="Dialect">Null for the default of the entry.</param>
public sealed record PostChoice(string Keyword, PostEntry Entry, string? Dialect)
{
    /// <summary>The reader; null if there is none.</summary>
    public IProgramReader? Reader => Dialect is null ? Entry.Reader : Entry.Dialects[Dialect];

    /// <summary>The post options that select the dialect.</summary>
    public IReadOnlyDictionary<string, string> Options => Dialect is null ? new Dictionary<string, string>() : new Dictionary<string, string> { ["dialect"] = Dialect };

    /// <summary>Name in tables.</summary>
    public string Name => $"{Entry.Post.Name} {Dialect ?? Entry.Dialects.Keys.Except(Entry.OtherDialects.Values).FirstOrDefault()}".TrimEnd();
}
