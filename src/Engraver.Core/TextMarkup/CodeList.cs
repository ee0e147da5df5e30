namespace Engraver.Core.TextMarkup;

/// <summary>Codes to report: each once, in the order in which they were found, up to a limit.</summary>
internal sealed class CodeList
{
    /// <summary>Maximum number of codes.</summary>
    public const int Capacity = 100;

    /// <summary>Maximum length of one; a longer one ends with an ellipsis.</summary>
    public const int MaxLength = 60;

    private readonly List<string> _codes = [];
    private readonly HashSet<string> _found = new(StringComparer.Ordinal);

    public IReadOnlyList<string> Codes => _codes;

    public void Add(ReadOnlySpan<char> code)
    {
        if (_codes.Count == Capacity) return;
        var shown = code.Length > MaxLength ? string.Concat(code[..(MaxLength - 1)], "…") : code.ToString();
        if (_found.Add(shown)) _codes.Add(shown);
    }
}
