using System.Globalization;
using Engraver.Core.Languages;

namespace Engraver.Workbench.CommandLanguage;

/// <summary>An option of a prompt. The capital letters and digits of its spelling are the accepted short form, at any position: <c>Window</c>, <c>eXit</c>,
/// <c>ALL</c>. It is shown in the current language and accepted in that language and in English; <c>_Window</c> is always English, as in AutoCAD.</summary>
/// <param name="Name">The English name used by commands and scripts.</param>
public sealed record Keyword(string Name)
{
    /// <summary>Set if another language has a different word for this use of the name: its text is <c>Keyword/Name.Use</c>.</summary>
    public string? Context { get; init; }

    /// <summary>The name in the current language.</summary>
    public string Shown => LanguageFile.For(CultureInfo.CurrentUICulture)?.Find(nameof(Keyword), Context is null ? Name : $"{Name}.{Context}") ?? Name;

    /// <summary>The capital letters and digits of its English name.</summary>
    public string Abbreviation => AbbreviationOf(Name);

    /// <summary>True for the capitals of the English name, the whole word, and every prefix that includes the last capital; case-insensitive.</summary>
    public bool Matches(string typed)
    {
        ArgumentNullException.ThrowIfNull(typed);
        return Matches(Name, typed);
    }

    /// <summary>The typed option, in the current language before English: a whole word before an abbreviation, an abbreviation before a prefix; null if none
    /// matches.</summary>
    public static Keyword? Find(IReadOnlyList<Keyword> options, string typed)
    {
        ArgumentNullException.ThrowIfNull(typed);
        return typed is ['_', .. var english]
            ? Find(options, english, option => option.Name)
            : Find(options, typed, option => option.Shown) ?? Find(options, typed, option => option.Name);
    }

    /// <summary>The displayed text of a default: an option in the current language, other text unchanged.</summary>
    public static string FormatDefault(IReadOnlyList<Keyword> options, string standard) => TextCatalogue.Fact(options.FirstOrDefault(option => option.Name == standard)?.Shown ?? standard);

    /// <summary>Options from their English spellings.</summary>
    public static IReadOnlyList<Keyword> List(params ReadOnlySpan<string> names)
    {
        var options = new Keyword[names.Length];
        for (var i = 0; i < options.Length; i++) options[i] = new Keyword(names[i]);
        return options;
    }

    private static Keyword? Find(IReadOnlyList<Keyword> options, string typed, Func<Keyword, string> spelling) =>
        options.FirstOrDefault(option => spelling(option).Equals(typed, StringComparison.OrdinalIgnoreCase))
        ?? options.FirstOrDefault(option => AbbreviationOf(spelling(option)) is { Length: > 0 } letters && letters.Equals(typed, StringComparison.OrdinalIgnoreCase))
        ?? options.FirstOrDefault(option => Matches(spelling(option), typed));

    private static bool Matches(string spelling, string typed)
    {
        var letters = AbbreviationOf(spelling);
        if (typed.Equals(letters, StringComparison.OrdinalIgnoreCase)) return true;
        var least = 1 + spelling.LastIndexOfAny([.. letters]);
        return typed.Length >= Math.Max(1, least) && spelling.StartsWith(typed, StringComparison.OrdinalIgnoreCase);
    }

    private static string AbbreviationOf(string spelling) => string.Concat(spelling.Where(letter => char.IsUpper(letter) || char.IsAsciiDigit(letter)));
}
