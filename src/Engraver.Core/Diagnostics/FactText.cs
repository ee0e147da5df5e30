using System.Globalization;

namespace Engraver.Core.Diagnostics;

/// <summary>Numbers as facts of a diagnostic.</summary>
public static class FactText
{
    /// <summary>A number with at most six decimals, invariant: millimetres to the nanometre.</summary>
    public static string Of(double number) => number.ToString("0.######", CultureInfo.InvariantCulture);
}
