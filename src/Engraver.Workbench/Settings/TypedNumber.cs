using System.Globalization;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Settings;

/// <summary>Numbers as options and files have them: invariant, finite.</summary>
public static class TypedNumber
{
    /// <summary>The largest number that an option takes, in either direction: a thousand kilometres in millimetres. Points may be farther away (drawings of
    /// maps). A larger number is a typing error, and arithmetic with it overflows.</summary>
    public const double Largest = 1e9;

    /// <summary>Reads a number above 0.</summary>
    public static ParsedInput<double> AboveZero(string typed) => Read(typed, value => value > 0.0, "TypedNumber.NotAboveZero");

    /// <summary>Reads a number from 0.</summary>
    public static ParsedInput<double> FromZero(string typed) => Read(typed, value => value >= 0.0, "TypedNumber.NotFromZero");

    /// <summary>The number such that <see cref="Parse"/> returns the same one.</summary>
    public static string Exact(double value) => value.ToString("R", CultureInfo.InvariantCulture);

    /// <exception cref="FormatException">The word is not a finite number.</exception>
    public static double Parse(string word) => double.TryParse(word, NumberStyles.Float, CultureInfo.InvariantCulture, out var value) && double.IsFinite(value) ? value : throw new FormatException(word);

    private static ParsedInput<double> Read(string typed, Func<double, bool> isAllowed, string text) =>
        NumberPrompt.TryParse(typed, out var value) && value <= Largest && isAllowed(value) ? new ParsedInput<double>.Value(value) : new ParsedInput<double>.Invalid(Wording.Get(text, typed));
}
