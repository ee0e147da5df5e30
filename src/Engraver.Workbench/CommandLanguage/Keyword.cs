namespace Engraver.Workbench.CommandLanguage;

/// <summary>An option of a prompt. The capital letters of its spelling are the accepted short form, wherever they stand: <c>Window</c>, <c>eXit</c>, <c>ALL</c>.</summary>
/// <param name="Name">As it is shown.</param>
public sealed record Keyword(string Name)
{
    /// <summary>The capital letters.</summary>
    public string Short => string.Concat(Name.Where(char.IsAsciiLetterUpper));

    /// <summary>True for the capitals, the whole word, and every beginning that reaches the last capital; case does not matter.</summary>
    public bool Means(string typed)
    {
        ArgumentNullException.ThrowIfNull(typed);
        if (typed.Equals(Short, StringComparison.OrdinalIgnoreCase)) return true;
        var least = 1 + Name.LastIndexOfAny([.. Short]);
        return typed.Length >= Math.Max(1, least) && Name.StartsWith(typed, StringComparison.OrdinalIgnoreCase);
    }

    /// <summary>The option that was typed: a whole word before a short form, a short form before a beginning; null when none was.</summary>
    public static Keyword? Find(IReadOnlyList<Keyword> options, string typed) =>
        options.FirstOrDefault(option => option.Name.Equals(typed, StringComparison.OrdinalIgnoreCase))
        ?? options.FirstOrDefault(option => option.Short.Length > 0 && option.Short.Equals(typed, StringComparison.OrdinalIgnoreCase))
        ?? options.FirstOrDefault(option => option.Means(typed));

    /// <summary>Options from their spellings.</summary>
    public static IReadOnlyList<Keyword> List(params ReadOnlySpan<string> names)
    {
        var options = new Keyword[names.Length];
        for (var i = 0; i < options.Length; i++) options[i] = new Keyword(names[i]);
        return options;
    }
}
