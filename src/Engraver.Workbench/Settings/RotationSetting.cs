using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Settings;

/// <summary>An angle in degrees, counter-clockwise positive. Not kept where it is 0.</summary>
public sealed class RotationSetting(string key, Func<DrawingSettings, Angle> get, Func<DrawingSettings, Angle, DrawingSettings> with) : Setting<Angle>(key, get, with)
{
    public override string? OptionDefault => DefaultText;

    protected override string DefaultText => TypedNumber.Exact(DefaultValue.Degrees);

    public override ParsedInput<Angle> ReadOption(string typed) => NumberPrompt.TryParse(typed, out var degrees) && Math.Abs(degrees) <= Max
        ? new ParsedInput<Angle>.Value(Angle.FromDegrees(degrees))
        : new ParsedInput<Angle>.Invalid(Wording.Get("Setting.rotate.Invalid", typed, Max));

    protected override string? WordOf(Angle value) => value == DefaultValue ? null : TypedNumber.Exact(value.Degrees);

    protected override Angle ParseWord(string word) => Angle.FromDegrees(TypedNumber.Parse(word));
}
