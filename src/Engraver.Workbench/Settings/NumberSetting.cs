using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Settings;

/// <summary>A number with a unit. The option takes every number above 0, or from 0 when <see cref="Setting.Min"/> is 0; the command's range is
/// narrower.</summary>
public class NumberSetting(string key, Func<DrawingSettings, double> get, Func<DrawingSettings, double, DrawingSettings> with) : Setting<double>(key, get, with)
{
    public override string? OptionDefault => DefaultText;

    public override ParsedInput<double> ReadOption(string typed) => Min > 0.0 ? TypedNumber.AboveZero(typed) : TypedNumber.FromZero(typed);

    public override string ToInput(DrawingSettings settings) => NumberPrompt.Format(Get(settings));

    public override DrawingSettings FromInput(DrawingSettings settings, string input) => With(settings, TypedNumber.Parse(input));

    protected override string? WordOf(double value) => TypedNumber.Exact(value);

    protected override double ParseWord(string word) => TypedNumber.Parse(word) is var value && (value == DefaultValue || (Min > 0.0 ? value > 0.0 : value >= 0.0)) ? value : throw new FormatException(word);
}
