using Engraver.Core.Drawings;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Settings;

/// <summary>The unit of the drawing; null for the unit stated in the file. The console has words, the command and files the code of $INSUNITS.</summary>
public sealed class UnitSetting : Setting<LengthUnit?>
{
    private const string Auto = "auto";
    private const string Unitless = "0";

    public UnitSetting(string key, Func<DrawingSettings, LengthUnit?> get, Func<DrawingSettings, LengthUnit?, DrawingSettings> with)
        : base(key, get, with) => (Min, Max, Whole) = (0, 24, true);

    public override string? Argument => string.Join('|', OptionWords);

    public override IReadOnlyList<string> OptionWords => ["mm", "inch", Auto];

    public override bool IsOneWord => true;

    public override string? OptionDefault => Auto;

    public override ParsedInput<LengthUnit?> ReadOption(string typed) => new ParsedInput<LengthUnit?>.Value(typed switch { "mm" => LengthUnits.ChosenFrom(4), "inch" => LengthUnits.ChosenFrom(1), _ => null });

    public override string ToInput(DrawingSettings settings) => ToWord(settings) ?? Unitless;

    public override DrawingSettings FromInput(DrawingSettings settings, string input) => With(settings, LengthUnits.ChosenFrom(TypedNumber.Parse(input)));

    protected override string? WordOf(LengthUnit? value) => value is null ? null : TypedNumber.Exact(value.Code);

    protected override LengthUnit? ParseWord(string word) => LengthUnits.ChosenFrom(TypedNumber.Parse(word)) ?? throw new FormatException(word);
}
