using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Settings;

/// <summary>The factor of a drawing: a number, or a ratio as on drawings, 1:2 for half the size.</summary>
public sealed class ScaleSetting(string key, Func<DrawingSettings, double> get, Func<DrawingSettings, double, DrawingSettings> with) : OptionalNumberSetting(key, get, with)
{
    public override ParsedInput<double> ReadOption(string typed)
    {
        ArgumentNullException.ThrowIfNull(typed);
        if (typed.Split(':') is not [var made, var drawn]) return base.ReadOption(typed);
        return base.ReadOption(made) is ParsedInput<double>.Value { Result: var numerator } && base.ReadOption(drawn) is ParsedInput<double>.Value { Result: var denominator }
            ? new ParsedInput<double>.Value(numerator / denominator)
            : new ParsedInput<double>.Invalid(Wording.Get("Setting.scale.Invalid", typed));
    }
}
