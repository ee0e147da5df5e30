using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Settings;

/// <summary>The factor of a drawing: a number, or a ratio as on drawings, 1:2 for half the size. Not kept where it is 1.</summary>
public sealed class ScaleSetting(string key, Func<DrawingSettings, double> get, Func<DrawingSettings, double, DrawingSettings> with) : NumberSetting(key, get, with)
{
    protected override string DefaultText => TypedNumber.Exact(DefaultValue);

    public override ParsedInput<double> ReadOption(string typed)
    {
        ArgumentNullException.ThrowIfNull(typed);
        if (typed.Split(':') is not [var made, var drawn]) return base.ReadOption(typed);
        return base.ReadOption(made) is ParsedInput<double>.Value { Result: var numerator } && base.ReadOption(drawn) is ParsedInput<double>.Value { Result: var denominator }
            ? new ParsedInput<double>.Value(numerator / denominator)
            : new ParsedInput<double>.Invalid(Wording.Get("Setting.scale.Invalid", typed));
    }

    protected override string? WordOf(double value) => value == DefaultValue ? null : base.WordOf(value);
}
