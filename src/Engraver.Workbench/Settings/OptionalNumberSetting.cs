namespace Engraver.Workbench.Settings;

/// <summary>A number that files do not keep where it is the default.</summary>
public class OptionalNumberSetting(string key, Func<DrawingSettings, double> get, Func<DrawingSettings, double, DrawingSettings> with) : NumberSetting(key, get, with)
{
    protected override string DefaultText => TypedNumber.Exact(DefaultValue);

    protected override string? WordOf(double value) => value == DefaultValue ? null : base.WordOf(value);
}
