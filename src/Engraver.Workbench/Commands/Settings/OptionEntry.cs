using System.Globalization;
using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Settings;

/// <summary>One setting in a window of settings.</summary>
/// <param name="Page">Name of its page; the title is the text <c>OptionPage.PAGE</c>.</param>
/// <param name="Key">Its permanent name.</param>
/// <param name="Command">What is typed for it.</param>
public sealed record OptionEntry(string Page, string Key, string Command)
{
    public required string Name { get; init; }

    /// <summary>What it does, in one or two sentences.</summary>
    public required string Meaning { get; init; }

    public string Unit { get; init; } = "";

    public double Min { get; init; }

    public double Max { get; init; }

    public bool IsInteger { get; init; }

    public string Default { get; init; } = "";

    /// <summary>The words that may be chosen, as commands know them; empty for a number.</summary>
    public IReadOnlyList<string> Choices { get; init; } = [];

    /// <summary>The same with what is shown for them in the language of now.</summary>
    public IReadOnlyList<OptionChoice> DisplayChoices => [.. Choices.Select(choice => new OptionChoice(choice, DisplayName(choice)))];

    /// <summary>The first value, as it is shown.</summary>
    public string DisplayDefault => Choices.FirstOrDefault(choice => choice.Equals(Default, StringComparison.OrdinalIgnoreCase)) is { } choice ? DisplayName(choice) : Default;

    /// <summary>As it is now.</summary>
    public string Value { get; init; } = "";

    /// <summary>No value is allowed too.</summary>
    public bool AllowsEmpty { get; init; }

    /// <summary>It is on or off: 1 or 0.</summary>
    public bool IsSwitch => Choices.Count == 0 && IsInteger && (Min, Max) == (0.0, 1.0);

    /// <summary>The title of its page.</summary>
    public string PageTitle => Wording.Get("OptionPage." + Page);

    /// <summary>What is wrong with a typed value, in a sentence; null when it can be taken.</summary>
    public string? RefusalOf(string typed)
    {
        ArgumentNullException.ThrowIfNull(typed);
        if (typed.Length == 0) return AllowsEmpty ? null : Wording.Get("PendingValue.InputRequired", Name);
        if (Choices.Count > 0) return Choices.Contains(typed) ? null : Wording.Get("ChoicePrompt.NotAnOption", typed, string.Join(", ", Choices.Select(DisplayName)));
        return new NumberPrompt(Name) { Min = Min, Max = Max, IsInteger = IsInteger }.Parse(typed, Point2D.Origin) is ParsedInput<double>.Invalid wrong ? wrong.Message : null;
    }

    private static string DisplayName(string choice) => new Keyword(choice).Shown is var shown && shown == choice ? choice : Capitalised(shown);

    /// <summary>The capitals inside of an option mark what is typed for it; in a list they mean nothing.</summary>
    private static string Capitalised(string option) => option[..1].ToUpper(CultureInfo.CurrentUICulture) + option[1..].ToLower(CultureInfo.CurrentUICulture);

    /// <summary>The words of a search are in its name, its command or its meaning.</summary>
    public bool Matches(string words)
    {
        ArgumentNullException.ThrowIfNull(words);
        return words.Split(' ', StringSplitOptions.RemoveEmptyEntries).All(word => Name.Contains(word, StringComparison.CurrentCultureIgnoreCase)
            || Command.Contains(word, StringComparison.OrdinalIgnoreCase) || Meaning.Contains(word, StringComparison.CurrentCultureIgnoreCase) || PageTitle.Contains(word, StringComparison.CurrentCultureIgnoreCase));
    }
}
