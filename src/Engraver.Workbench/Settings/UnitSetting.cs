using Engraver.Core.Drawings;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Settings;

/// <summary>The unit of the drawing; null for the unit stated in the file. The console has words, the command and files the code of $INSUNITS.</summary>
public sealed class UnitSetting : Setting<LengthUnit?>
{
    private const string Auto = "auto";
    private const string Unitless = "0";

    /// <summary>The words of the option, and their codes.</summary>
    private static readonly Dictionary<string, int> s_codes = new(StringComparer.Ordinal) { ["mm"] = 4, ["inch"] = 1, ["cm"] = 5, ["m"] = 6, ["ft"] = 2 };

    public UnitSetting(string key, Func<DrawingSettings, LengthUnit?> get, Func<DrawingSettings, LengthUnit?, DrawingSettings> with)
        : base(key, get, with) => (Min, Max, Whole) = (0, 24, true);

    public override string? Argument => string.Join('|', OptionWords);

    public override IReadOnlyList<string> OptionWords => [.. s_codes.Keys, Auto];

    public override bool IsOneWord => true;

    public override string? OptionDefault => Auto;

    public override ParsedInput<LengthUnit?> ReadOption(string typed) => new ParsedInput<LengthUnit?>.Value(s_codes.TryGetValue(typed, out var code) ? LengthUnits.ChosenFrom(code) : null);

    public override string ToInput(DrawingSettings settings) => ToWord(settings) ?? Unitless;

    public override DrawingSettings FromInput(DrawingSettings settings, string input) => With(settings, LengthUnits.ChosenFrom(TypedNumber.Parse(input)));

    protected override string? WordOf(LengthUnit? value) => value is null ? null : TypedNumber.Exact(value.Code);

    protected override LengthUnit? ParseWord(string word) => LengthUnits.ChosenFrom(TypedNumber.Parse(word)) ?? throw new FormatException(word);
}
