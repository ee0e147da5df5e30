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
        Name = setting.Name, Meaning = SettingWording.AtCommandLine(setting.Meaning), Unit = setting.Unit, Min = setting.Min, Max = setting.Max, IsInteger = setting.Whole, Default = setting.Default,
        Choices = setting.Choices, Value = setting.ToInput(session.Document.Current.Settings), AllowsEmpty = setting.MayBeEmpty,
    };

    private static OptionEntry Variable(CommandSession session, SystemVariable variable)
    {
        var info = session.Catalog.Find(variable.Name)!.Info;
        return new OptionEntry(SystemVariables.IsInView(variable.Name) ? "Drafting" : "Screen", variable.Name, variable.Name)
        {
            Name = variable.Name, Meaning = info.Summary, Min = variable.Min, Max = variable.Max, IsInteger = variable.IsInteger, Default = NumberPrompt.Format(variable.First), Value = Shown(session, variable.Name),
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
    /// <param name="shown">All values as shown in the window, by key.</param>
    public static IReadOnlyList<string> InputsFor(OptionEntry changed, IReadOnlyDictionary<string, string> shown)
    {
        ArgumentNullException.ThrowIfNull(changed);
        ArgumentNullException.ThrowIfNull(shown);
        if (changed.Command != SettingTable.Kerf.Command) return [changed.Command, changed.Choices.Count > 0 ? English + shown[changed.Key] : shown[changed.Key]];
        var (side, diameter) = (shown[SettingTable.Kerf.Key], shown[SettingTable.ToolDiameter.Key]);
        return side == KerfSetting.Off ? [changed.Command, English + side] : [changed.Command, English + side, diameter];
    }
}
