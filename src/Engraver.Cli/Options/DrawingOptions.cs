using System.CommandLine;
using Engraver.Workbench.Settings;

namespace Engraver.Cli.Options;

/// <summary>The file argument and the options shared by the drawing verbs: one for each setting of the table that has an option.</summary>
internal sealed class DrawingOptions
{
    private readonly Argument<string> _file = new("FILE") { Description = Wording.Get("DrawingOptions.Drawing") };
    private readonly IReadOnlyList<(Setting Setting, Option Option)> _options = [.. SettingTable.All.Where(setting => setting.HasOption).Select(setting => (setting, SettingOption.For(setting)))];

    public void AddTo(Command command)
    {
        command.Arguments.Add(_file);
        AddOptionsTo(command);
    }

    /// <summary>For a verb whose drawing is named by an option of its own.</summary>
    public void AddOptionsTo(Command command)
    {
        foreach (var (_, option) in _options) command.Options.Add(option);
    }

    public string File(ParseResult parsed) => parsed.GetRequiredValue(_file);

    /// <exception cref="SettingException">A value is not valid, or the machine profile cannot be used.</exception>
    /// <exception cref="UsageException">Options that cannot be used together.</exception>
    public DrawingSettings Settings(ParseResult parsed)
    {
        var settings = DrawingSettings.Default;
        foreach (var (setting, option) in _options)
        {
            if (SettingOption.TextOf(parsed, option) is { } typed) settings = setting.FromOption(settings, typed, ProfileOption.Warnings(parsed));
        }

        foreach (var (setting, _) in _options)
        {
            if (setting.Conflict(settings) is { } conflict) throw new UsageException(SettingWording.OnConsole(conflict));
        }

        return settings;
    }
}
