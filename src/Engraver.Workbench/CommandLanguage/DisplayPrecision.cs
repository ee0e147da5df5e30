using System.Globalization;
using Engraver.Core.Geometry;

namespace Engraver.Workbench.CommandLanguage;

/// <summary>Format of measured lengths and angles: rounded to a number of decimals, without trailing zeros. Used by prompts, DIST, ID, AREA, LIST, the
/// properties and the coordinates at the cursor.</summary>
/// <param name="LengthDecimals">Decimals of lengths, coordinates and areas (LUPREC).</param>
/// <param name="AngleDecimals">Decimals of angles in degrees (AUPREC).</param>
public readonly record struct DisplayPrecision(int LengthDecimals, int AngleDecimals)
{
    /// <summary>Minimum significant digits of a default, so that a tolerance of 0.00002 is not shown as 0.</summary>
    private const int MinDigits = 4;

    private const int MaxPlaces = 15;

    /// <summary>The initial settings.</summary>
    public static DisplayPrecision Initial { get; } = new(4, 2);

    /// <summary>A length, coordinate or factor.</summary>
    public string FormatLength(double value) => Rounded(value, LengthDecimals);

    /// <summary>An area, drawing units squared.</summary>
    public string FormatArea(double value) => Rounded(value, LengthDecimals);

    public string FormatDegrees(Angle angle) => Rounded(angle.Degrees, AngleDecimals);

    /// <summary>A point as <c>x,y</c>.</summary>
    public string FormatPoint(Point2D place) => $"{FormatLength(place.X)},{FormatLength(place.Y)}";

    /// <summary>A length or coordinate at the cursor: with trailing zeros, so that the width of the text does not change while the cursor moves.</summary>
    public string FormatCursorLength(double value) => Fixed(value, LengthDecimals);

    /// <summary>An angle at the cursor.</summary>
    public string FormatCursorDegrees(Angle angle) => Fixed(angle.Degrees, AngleDecimals);

    /// <summary>An error bound: three digits, at most six decimals, never rounded down; smaller values are shown as 0.000001.</summary>
    public static string FormatErrorBound(double bound)
    {
        if (!(bound > 0.0)) return "0";
        var scale = Math.Max(1e-6, Math.Pow(10.0, Math.Floor(Math.Log10(bound)) - 2.0));
        return (Math.Max(1.0, Math.Ceiling((bound / scale) - 1e-9)) * scale).ToString("0.######", CultureInfo.InvariantCulture);
    }

    /// <summary>A default as shown in a prompt: a number or point with a limited number of decimals; other text unchanged.</summary>
    /// <remarks>Enter still uses the unrounded number.</remarks>
    public string FormatDefault(string standard)
    {
        ArgumentNullException.ThrowIfNull(standard);
        var parts = standard.Split(',');
        if (parts.Length > 2 || !Array.TrueForAll(parts, IsLongNumber)) return standard;
        var (places, shown) = (LengthDecimals, new string[parts.Length]);
        for (var i = 0; i < parts.Length; i++) shown[i] = Shortened(parts[i], places);
        return string.Join(',', shown);
    }

    /// <summary>Numbers with a point are shortened; integers, names and handles are not.</summary>
    private static bool IsLongNumber(string text) => text.Length > 0 && (text.Contains('.', StringComparison.Ordinal) || text.All(letter => char.IsAsciiDigit(letter) || letter == '-')) && NumberPrompt.TryParse(text, out _);

    private static string Shortened(string text, int places)
    {
        if (!NumberPrompt.TryParse(text, out var value) || value == 0.0) return text;
        var shown = Rounded(value, Math.Clamp(MinDigits - 1 - (int)Math.Floor(Math.Log10(Math.Abs(value))), places, MaxPlaces));
        return shown.Length < text.Length ? shown : text;
    }

    private static string Rounded(double value, int places) =>
        RoundToPlaces(value, places).ToString("0." + new string('#', places), CultureInfo.InvariantCulture);

    private static string Fixed(double value, int places) => RoundToPlaces(value, places).ToString("0." + new string('0', places), CultureInfo.InvariantCulture);

    /// <summary>Rounds; negative zero becomes zero.</summary>
    private static double RoundToPlaces(double value, int places) => Math.Abs(value) < 1e15 ? Math.Round(value, places, MidpointRounding.AwayFromZero) + 0.0 : value;
}
