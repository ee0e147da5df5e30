using System.CommandLine;
using Engraver.Core.Languages;
using Engraver.Workbench.Settings;

namespace Engraver.Cli.Options;

/// <summary>The option of a setting that has a value. Name, argument, default and help come from the table of settings; the setting reads the text.</summary>
internal sealed class SettingOption : Option<string?>
{
    private SettingOption(Setting setting)
        : base(setting.Option!)
    {
        MayBeEmpty = setting.OptionMayBeEmpty;
        if (setting.OptionDefault is { } standard) DefaultValueFactory = _ => standard;
        if (setting.IsOneWord)
        {
            this.AcceptOnlyFromAmong([.. setting.OptionWords]);
            return;
        }

        HelpName = setting.Argument;
        CompletionSources.Add([.. setting.OptionWords]);
        Validators.Add(result =>
        {
            if (result is { Implicit: false, Tokens: [var typed] } && setting.WhyNotOption(typed.Value) is { } why) result.AddError($"{TextCatalogue.Fact(Name)}: {why}");
        });
    }

    /// <summary>An empty text is a value.</summary>
    public bool MayBeEmpty { get; }

    /// <summary>The option of a setting; a switch has no value.</summary>
    public static Option For(Setting setting)
    {
        Option option = setting.IsSwitch ? new Option<bool>(setting.Option!) : new SettingOption(setting);
        option.Description = SettingWording.OnConsole(setting.Meaning);
        return option;
    }

    /// <summary>The text that was given for an option of <see cref="For"/>; null when it was not given.</summary>
    public static string? TextOf(ParseResult parsed, Option option)
    {
        if (parsed.GetResult(option) is not { Implicit: false }) return null;
        return option is Option<bool> isOn ? SwitchSetting.OptionText(parsed.GetValue(isOn)) : parsed.GetValue((SettingOption)option);
    }
}
