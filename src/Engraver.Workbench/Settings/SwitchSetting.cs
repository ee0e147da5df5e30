using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Settings;

/// <summary>On or off: 1 or 0 at the command and in files.</summary>
public sealed class SwitchSetting : Setting<bool>
{
    private const string On = "1";
    private const string Off = "0";

    public SwitchSetting(string key, Func<DrawingSettings, bool> get, Func<DrawingSettings, bool, DrawingSettings> with)
        : base(key, get, with) => (Min, Max, Whole) = (0, 1, true);

    public override bool IsSwitch => true;

    public override ParsedInput<bool> ReadOption(string typed) => new ParsedInput<bool>.Value(typed == On);

    protected override string WordOf(bool value) => value ? On : Off;

    protected override bool ParseWord(string word) => word == On;

    /// <summary>The text of the option for a value.</summary>
    public static string OptionText(bool isOn) => isOn ? On : Off;
}
