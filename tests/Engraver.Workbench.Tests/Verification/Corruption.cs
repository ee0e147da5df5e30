using System.Globalization;
using System.Text.RegularExpressions;

namespace Engraver.Workbench.Tests.Verification;

/// <summary>Seeded corruption of a program: one character or one number is changed.</summary>
internal static partial class Corruption
{
    public static string Of(Random random, string text, int number) => number % 2 == 0 ? WithOtherCharacter(random, text) : WithOtherNumber(random, text);

    private static string WithOtherCharacter(Random random, string text)
    {
        var place = random.Next(text.Length);
        return random.Next(3) switch
        {
            0 => text.Remove(place, 1),
            1 => text.Insert(place, text[random.Next(text.Length)].ToString()),
            _ => text[..place] + text[random.Next(text.Length)] + text[(place + 1)..],
        };
    }

    /// <summary>Another number with as many decimals, often close to the original.</summary>
    private static string WithOtherNumber(Random random, string text)
    {
        var found = Number().Matches(text);
        var one = found[random.Next(found.Count)];
        var decimals = one.Value.IndexOf('.', StringComparison.Ordinal) is >= 0 and var point ? one.Length - point - 1 : 0;
        var old = double.Parse(one.Value, CultureInfo.InvariantCulture);
        var other = random.Next(2) == 0 ? old + (random.Next(1, 12) * Math.Pow(10.0, -random.Next(decimals + 1))) : random.NextDouble() * 200.0;
        return text[..one.Index] + other.ToString("F" + decimals, CultureInfo.InvariantCulture) + text[(one.Index + one.Length)..];
    }

    [GeneratedRegex(@"-?\d+(\.\d+)?")]
    private static partial Regex Number();
}
