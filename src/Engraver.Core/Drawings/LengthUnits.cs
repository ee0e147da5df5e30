namespace Engraver.Core.Drawings;

/// <summary>The 24 units of $INSUNITS (DXF reference, HEADER).</summary>
public static class LengthUnits
{
    /// <summary>Millimetres of an inch.</summary>
    internal const double Inch = 25.4;

    private const double Foot = 304.8;
    private const double SurveyFoot = 1_200_000.0 / 3937.0;
    private const double AstronomicalUnit = 149_597_870_700_000.0;

    private static readonly (string Name, double MillimetresPerUnit)[] Units =
    [
        ("in", Inch), ("ft", Foot), ("mi", 5280.0 * Foot), ("mm", 1.0), ("cm", 10.0), ("m", 1e3), ("km", 1e6), ("uin", 25.4e-6),
        ("mil", 25.4e-3), ("yd", 3.0 * Foot), ("angstrom", 1e-7), ("nm", 1e-6), ("um", 1e-3), ("dm", 1e2), ("dam", 1e4), ("hm", 1e5),
        ("Gm", 1e12), ("au", AstronomicalUnit), ("ly", 9.460_730_472_580_8e18), ("pc", AstronomicalUnit * 648_000.0 / Math.PI),
        ("usft", SurveyFoot), ("usin", SurveyFoot / 12.0), ("usyd", 3.0 * SurveyFoot), ("usmi", 5280.0 * SurveyFoot),
    ];

    /// <summary>The unit of an $INSUNITS code, 1 to 24; null for every other number (0 is "unitless").</summary>
    public static LengthUnit? FromInsUnits(double code)
    {
        if (!(code >= 1.0 && code <= Units.Length) || code != Math.Floor(code)) return null;
        var (name, factor) = Units[(int)code - 1];
        return new LengthUnit((int)code, name, "INSUNITS", factor);
    }

    /// <summary>A length that is shown in inches besides.</summary>
    public static double InInches(double millimetres) => millimetres / Inch;

    /// <summary>The same unit when the operator chooses it.</summary>
    public static LengthUnit? ChosenFrom(double code) => FromInsUnits(code) is { } unit ? unit with { Source = LengthUnit.Chosen } : null;
}
