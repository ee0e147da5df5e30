using System.Globalization;
using Engraver.Core.Languages;

namespace Engraver.Workbench.CommandLanguage;

/// <summary>An option of a prompt. The capital letters and digits of its spelling are the accepted short form, wherever they stand: <c>Window</c>,
/// <c>eXit</c>, <c>ALL</c>. It is shown in the language of now, and answers to that and to English; <c>_Window</c> is English whatever is spoken, as in
/// AutoCAD.</summary>
/// <param name="Name">In English: what commands and scripts know it by.</param>
public sealed record Keyword(string Name)
{
    /// <summary>Set where another language has a different word for this use of the name: its text is <c>Keyword/Name.Use</c>.</summary>
    public string? Use { get; init; }

    /// <summary>As it is shown: in the language of now.</summary>
    public string Shown => LanguageFile.For(CultureInfo.CurrentUICulture)?.Find(nameof(Keyword), Use is null ? Name : $"{Name}.{Use}") ?? Name;

    /// <summary>The capital letters and digits of its English name.</summary>
    public string Short => ShortOf(Name);

    /// <summary>True for the capitals of the English name, the whole word, and every beginning that reaches the last capital; case does not matter.</summary>
    public bool Means(string typed)
    {
        ArgumentNullException.ThrowIfNull(typed);
        return Means(Name, typed);
    }

    /// <summary>The option that was typed, in the language of now before English: a whole word before a short form, a short form before a beginning; null
    /// when none was.</summary>
    public static Keyword? Find(IReadOnlyList<Keyword> options, string typed)
    {
        ArgumentNullException.ThrowIfNull(typed);
        return typed is ['_', .. var english]
            ? Find(options, english, option => option.Name)
            : Find(options, typed, option => option.Shown) ?? Find(options, typed, option => option.Name);
    }

    /// <summary>How a default is shown that is the name of one of the options; every other default is shown as it is.</summary>
    public static string ShowDefault(IReadOnlyList<Keyword> options, string standard) => TextCatalogue.Fact(options.FirstOrDefault(option => option.Name == standard)?.Shown ?? standard);

    /// <summary>Options from their English spellings.</summary>
    public static IReadOnlyList<Keyword> List(params ReadOnlySpan<string> names)
    {
        var options = new Keyword[names.Length];
        for (var i = 0; i < options.Length; i++) options[i] = new Keyword(names[i]);
        return options;
    }

    private static Keyword? Find(IReadOnlyList<Keyword> options, string typed, Func<Keyword, string> spelling) =>
        options.FirstOrDefault(option => spelling(option).Equals(typed, StringComparison.OrdinalIgnoreCase))
        ?? options.FirstOrDefault(option => ShortOf(spelling(option)) is { Length: > 0 } letters && letters.Equals(typed, StringComparison.OrdinalIgnoreCase))
        ?? options.FirstOrDefault(option => Means(spelling(option), typed));

    private static bool Means(string spelling, string typed)
    {
        var letters = ShortOf(spelling);
        if (typed.Equals(letters, StringComparison.OrdinalIgnoreCase)) return true;
        var least = 1 + spelling.LastIndexOfAny([.. letters]);
        return typed.Length >= Math.Max(1, least) && spelling.StartsWith(typed, StringComparison.OrdinalIgnoreCase);
    }

    private static string ShortOf(string spelling) => string.Concat(spelling.Where(letter => char.IsUpper(letter) || char.IsAsciiDigit(letter)));
}
