using System.Globalization;
using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Commands.Settings;

/// <summary>Every setting that a person may choose, on pages, as a window of settings shows them: from the table of settings and that of the system
/// variables. A value is changed by the command that is typed for it.</summary>
public static class OptionTable
{
    /// <summary>Before an option: it is read as English in every language.</summary>
    private const string English = "_";

    /// <summary>The settings with their values as they are now.</summary>
    public static IReadOnlyList<OptionEntry> Of(CommandSession session)
    {
        ArgumentNullException.ThrowIfNull(session);
        var rows = SettingTable.All.Where(setting => setting.Page is not null).OrderBy(setting => setting.Page).Select(setting => Described(session, setting)); // a stable order
        var variables = SystemVariables.All.Select(variable => Variable(session, variable));
        var theme = Chosen(session, "THEME", Enum.GetNames<DesktopTheme>(), session.View.Current.Theme.ToString());
        var language = Chosen(session, "LANGUAGE", LanguageCommand.Choices, LanguageCommand.NameOf(session.Settings.Current));
        return [.. rows, theme, language, .. variables.OrderBy(entry => entry.Page, StringComparer.Ordinal)];
    }

    private static OptionEntry Described(CommandSession session, Setting setting) => new(setting.Page!.Value.ToString(), setting.Key, setting.Command)
    {
        Name = setting.Name, Meaning = SettingWording.AtCommandLine(setting.Meaning), Unit = setting.Unit, Least = setting.Min, Most = setting.Max, Whole = setting.Whole, Default = setting.Default,
        Choices = setting.Choices, Value = setting.ToInput(session.Document.Current.Settings), MayBeEmpty = setting.MayBeEmpty,
    };

    private static OptionEntry Variable(CommandSession session, SystemVariable variable)
    {
        var info = session.Catalog.Find(variable.Name)!.Info;
        return new OptionEntry(SystemVariables.IsInView(variable.Name) ? "Drafting" : "Screen", variable.Name, variable.Name)
        {
            Name = variable.Name, Meaning = info.Summary, Least = variable.Least, Most = variable.Most, Whole = variable.Whole, Default = NumberPrompt.Show(variable.First), Value = Shown(session, variable.Name),
        };
    }

    private static OptionEntry Chosen(CommandSession session, string command, IReadOnlyList<string> choices, string now)
    {
        var info = session.Catalog.Find(command)!.Info;
        return new OptionEntry("Screen", info.Name, info.Name) { Name = info.Name, Meaning = info.Summary, Choices = choices, Default = choices[0], Value = now };
    }

    private static string Shown(CommandSession session, string name)
    {
        var setting = (ISettingCommand)session.Catalog.Find(name)!;
        return setting.ValueText(new CommandContext(session, new CommandFrame(setting.Info)));
    }

    /// <summary>The inputs by which changed settings become what the window shows, one command each.</summary>
    /// <param name="shown">All values as they stand in the window, by key.</param>
    public static IReadOnlyList<string> InputsFor(OptionEntry changed, IReadOnlyDictionary<string, string> shown)
    {
        ArgumentNullException.ThrowIfNull(changed);
        ArgumentNullException.ThrowIfNull(shown);
        if (changed.Command != SettingTable.Kerf.Command) return [changed.Command, changed.Choices.Count > 0 ? English + shown[changed.Key] : shown[changed.Key]];
        var (side, diameter) = (shown[SettingTable.Kerf.Key], shown[SettingTable.ToolDiameter.Key]);
        return side == KerfSetting.Off ? [changed.Command, English + side] : [changed.Command, English + side, diameter];
    }
}

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

    public double Least { get; init; }

    public double Most { get; init; }

    public bool Whole { get; init; }

    public string Default { get; init; } = "";

    /// <summary>The words that may be chosen, as commands know them; empty for a number.</summary>
    public IReadOnlyList<string> Choices { get; init; } = [];

    /// <summary>The same with what is shown for them in the language of now.</summary>
    public IReadOnlyList<OptionChoice> ShownChoices => [.. Choices.Select(choice => new OptionChoice(choice, Shown(choice)))];

    /// <summary>The first value, as it is shown.</summary>
    public string ShownDefault => Choices.FirstOrDefault(choice => choice.Equals(Default, StringComparison.OrdinalIgnoreCase)) is { } choice ? Shown(choice) : Default;

    /// <summary>As it is now.</summary>
    public string Value { get; init; } = "";

    /// <summary>No value is allowed too.</summary>
    public bool MayBeEmpty { get; init; }

    /// <summary>It is on or off: 1 or 0.</summary>
    public bool IsSwitch => Choices.Count == 0 && Whole && (Least, Most) == (0.0, 1.0);

    /// <summary>The title of its page.</summary>
    public string PageTitle => Wording.Get("OptionPage." + Page);

    /// <summary>What is wrong with a typed value, in a sentence; null when it can be taken.</summary>
    public string? WhyNot(string typed)
    {
        ArgumentNullException.ThrowIfNull(typed);
        if (typed.Length == 0) return MayBeEmpty ? null : Wording.Get("PendingValue.InputRequired", Name);
        if (Choices.Count > 0) return Choices.Contains(typed) ? null : Wording.Get("ChoicePrompt.NotAnOption", typed, string.Join(", ", Choices.Select(Shown)));
        return new NumberPrompt(Name) { Least = Least, Most = Most, Whole = Whole }.Read(typed, Point2D.Origin) is Reading<double>.Wrong wrong ? wrong.Sentence : null;
    }

    private static string Shown(string choice) => new Keyword(choice).Shown is var shown && shown == choice ? choice : Capitalised(shown);

    /// <summary>The capitals inside of an option mark what is typed for it; in a list they mean nothing.</summary>
    private static string Capitalised(string option) => option[..1].ToUpper(CultureInfo.CurrentUICulture) + option[1..].ToLower(CultureInfo.CurrentUICulture);

    /// <summary>The words of a search stand in its name, its command or its meaning.</summary>
    public bool Holds(string words)
    {
        ArgumentNullException.ThrowIfNull(words);
        return words.Split(' ', StringSplitOptions.RemoveEmptyEntries).All(word => Name.Contains(word, StringComparison.CurrentCultureIgnoreCase)
            || Command.Contains(word, StringComparison.OrdinalIgnoreCase) || Meaning.Contains(word, StringComparison.CurrentCultureIgnoreCase) || PageTitle.Contains(word, StringComparison.CurrentCultureIgnoreCase));
    }
}

/// <summary>A word that may be chosen.</summary>
/// <param name="Value">As commands know it.</param>
/// <param name="Word">As it is shown.</param>
public sealed record OptionChoice(string Value, string Word);
