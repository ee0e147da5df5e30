namespace Engraver.Workbench.Settings;

/// <summary>A choice that files do not keep where it is the default.</summary>
public sealed class OptionalChoiceSetting<T>(string key, Func<DrawingSettings, T> get, Func<DrawingSettings, T, DrawingSettings> with) : ChoiceSetting<T>(key, get, with)
    where T : struct, Enum
{
    protected override string DefaultText => base.WordOf(DefaultValue)!;

    protected override string? WordOf(T value) => EqualityComparer<T>.Default.Equals(value, DefaultValue) ? null : base.WordOf(value);
}
