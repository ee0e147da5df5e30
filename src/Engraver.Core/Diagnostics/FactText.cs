namespace Engraver.Core.Diagnostics;

/// <summary>Numbers as facts of a diagnostic.</summary>
public static class FactText
{
    private const int MaxDecimals = 6;

    /// <summary>A number with at most six decimals, invariant: millimetres to the nanometre.</summary>
    public static string Of(double number) => NumberText.Rounded(number, MaxDecimals);

    /// <summary>A number rounded to so many decimals, half to even.</summary>
    public static string Of(double number, int decimals) => NumberText.Rounded(Math.Round(number, decimals), MaxDecimals);
}
