using Engraver.Core.Kerf;

namespace Engraver.Workbench.Settings;

/// <summary>The side of the lines on which the tool runs. Any side requires a tool diameter.</summary>
public sealed class KerfSetting(string key, Func<DrawingSettings, KerfSide> get, Func<DrawingSettings, KerfSide, DrawingSettings> with) : ChoiceSetting<KerfSide>(key, get, with)
{
    /// <summary>The choice without compensation, as the command offers it.</summary>
    public const string Off = "OFF";

    public override string? Conflict(DrawingSettings settings)
    {
        ArgumentNullException.ThrowIfNull(settings);
        return settings is { Kerf: not KerfSide.Off, ToolDiameterMm: 0.0 } ? Wording.Get("Setting.kerf.NeedsDiameter") : null;
    }

    protected override string InputName(string name) => name == nameof(KerfSide.Off) ? Off : name;
}

/// <summary>The diameter of the tool; 0 when it was not given.</summary>
public sealed class ToolDiameterSetting(string key, Func<DrawingSettings, double> get, Func<DrawingSettings, double, DrawingSettings> with) : NumberSetting(key, get, with)
{
    public override string? OptionDefault => null;

    public override bool MayBeEmpty => true;

    public override string ToInput(DrawingSettings settings) => Get(settings) > 0.0 ? base.ToInput(settings) : "";

    protected override string DefaultText => "";
}
