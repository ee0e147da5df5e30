using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Settings;

/// <summary>The number of the tool whose operations are run; 0 for all.</summary>
public sealed class ToolSetting(string key, Func<DrawingSettings, double> get, Func<DrawingSettings, double, DrawingSettings> with) : NumberSetting(key, get, with)
{
    public override string? OptionDefault => null;

    protected override string DefaultText => "";

    public override string? Conflict(DrawingSettings settings)
    {
        ArgumentNullException.ThrowIfNull(settings);
        return settings is { Tool: > 0, Operations: null } ? Wording.Get("Setting.tool-number.NeedsOperations") : null;
    }

    public override ParsedInput<double> ReadOption(string typed) => base.ReadOption(typed) is ParsedInput<double>.Value { Result: var number } value && number == Math.Floor(number) && number <= Max ? value : new ParsedInput<double>.Invalid(Wording.Get("Setting.tool-number.Invalid", typed, Max));

    protected override string? WordOf(double value) => value == 0.0 ? null : base.WordOf(value);
}
