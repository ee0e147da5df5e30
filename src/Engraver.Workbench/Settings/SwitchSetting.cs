using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Settings;

/// <summary>On or off: 1 or 0 at the command and in files, on or off as the value of an option.</summary>
public sealed class SwitchSetting : Setting<bool>
{
    private const string On = "1";
    private const string Off = "0";
    private const string OnWord = "on";
    private const string OffWord = "off";

    public SwitchSetting(string key, Func<DrawingSettings, bool> get, Func<DrawingSettings, bool, DrawingSettings> with)
        : base(key, get, with) => (Min, Max, Whole) = (0, 1, true);

    /// <summary>A switch that is on by default has an option with a value, by which it is set to off.</summary>
    public override bool IsSwitch => !DefaultValue;

    public override string? Argument => DefaultValue ? string.Join('|', OptionWords) : null;

    public override IReadOnlyList<string> OptionWords => DefaultValue ? [OnWord, OffWord] : [];

    public override bool IsOneWord => DefaultValue;

    public override string? OptionDefault => DefaultValue ? OnWord : null;

    public override ParsedInput<bool> ReadOption(string typed) => new ParsedInput<bool>.Value(typed is On or OnWord);

    protected override string WordOf(bool value) => value ? On : Off;

    protected override bool ParseWord(string word) => word == On;

    /// <summary>The text of the option for a value.</summary>
    public static string OptionText(bool isOn) => isOn ? On : Off;
}
