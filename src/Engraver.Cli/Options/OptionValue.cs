using System.CommandLine.Parsing;
using System.Text.RegularExpressions;
using Engraver.Core.Dxf.Records;
using Engraver.Core.Geometry;
using Engraver.Core.Machines.Origins;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Cli.Options;

/// <summary>Reads the values of options: invariant numbers only, and one sentence when a value cannot be read.</summary>
internal static partial class OptionValue
{
    /// <summary>The largest number that an option takes, in either direction: a thousand kilometres in millimetres; places may lie farther (drawings of
    /// maps). What is larger is a slip of the hand, and arithmetic with it overflows.</summary>
    private const double Largest = 1e9;

    public static double PositiveNumber(ArgumentResult result) => Number(result, value => value > 0.0, Wording.Get("OptionValue.NumberAboveZero"));

    public static double NumberFromZero(ArgumentResult result) => Number(result, value => value >= 0.0, Wording.Get("OptionValue.NumberFromZero"));

    public static double AnyNumber(ArgumentResult result) => Number(result, _ => true, Wording.Get("OptionValue.AnyNumber"));

    /// <summary>A whole number from 1 to a million.</summary>
    public static double WholeNumberFromOne(ArgumentResult result) => Number(result, value => value is >= 1.0 and <= 1e6 && value == Math.Floor(value), Wording.Get("OptionValue.WholeNumberFromOne"));

    public static double NumberFromOne(ArgumentResult result) => Number(result, value => value >= 1.0, Wording.Get("OptionValue.NumberFromOne"));

    /// <summary>Seconds above 0, at most a day.</summary>
    public static double SecondsOfADay(ArgumentResult result) => Number(result, value => value is > 0.0 and <= 86_400.0, Wording.Get("OptionValue.SecondsUpToADay"));

    /// <summary>Mm/min above 0 and below a million.</summary>
    public static double Speed(ArgumentResult result) => Number(result, value => value is > 0.0 and < 1e6, Wording.Get("OptionValue.Speed"));

    /// <summary>Above 0 and below 1.</summary>
    public static double NumberBelowOne(ArgumentResult result) => Number(result, value => value is > 0.0 and < 1.0, Wording.Get("OptionValue.NumberBelowOne"));

    /// <summary>Degrees above 0 and below 90.</summary>
    public static double RampAngle(ArgumentResult result) => Number(result, value => value is > 0.0 and < 90.0, Wording.Get("OptionValue.RampAngle"));

    public static Point2D Point(ArgumentResult result)
    {
        var word = result.Tokens[0].Value;
        if (TryPoint(word) is { } point) return point;
        result.AddError(Wording.Get("OptionValue.InvalidPoint", Name(result), word));
        return default;
    }

    public static Point2D? TryPoint(string word)
    {
        var parts = word.Split(',');
        return parts.Length == 2 && NumberPrompt.TryNumber(parts[0], out var x) && NumberPrompt.TryNumber(parts[1], out var y) ? new Point2D(x, y) : null;
    }

    /// <summary>The words of <see cref="CutChoice"/>, parted by commas.</summary>
    public static CutChoice Choices(ArgumentResult result)
    {
        var choice = CutChoice.None;
        foreach (var word in Names(result))
        {
            if (char.IsAsciiLetter(word[0]) && Enum.TryParse<CutChoice>(word, ignoreCase: true, out var one)) choice |= one;
            else result.AddError(Wording.Get("OptionValue.InvalidCut", Name(result), word));
        }

        return choice;
    }

    public static FinishPlace Finish(ArgumentResult result)
    {
        switch (result.Tokens[0].Value)
        {
            case "origin": return FinishPlace.Origin;
            case "stay": return FinishPlace.Stay;
            case "park": return FinishPlace.Park;
            default:
                result.AddError(Wording.Get("OptionValue.InvalidFinish", Name(result), result.Tokens[0].Value));
                return FinishPlace.Origin;
        }
    }

    public static IReadOnlyList<string> Names(ArgumentResult result) =>
        [.. QuotedName().Matches(result.Tokens[0].Value).Select(found => found.Groups["quoted"] is { Success: true, Value: var quoted } ? quoted.Replace("\"\"", "\"", StringComparison.Ordinal) : found.Groups["plain"].Value.Trim()).Where(name => name.Length > 0)];

    /// <summary>Names apart by commas; one with a comma in it stands in double quotes, in which a double quote is written twice.</summary>
    [GeneratedRegex("(?:^|,)\\s*(?:\"(?<quoted>(?:[^\"]|\"\")*)\"\\s*(?=,|$)|(?<plain>[^,]*))", RegexOptions.CultureInvariant)]
    private static partial Regex QuotedName();

    private static double Number(ArgumentResult result, Func<double, bool> allowed, string wanted)
    {
        var word = result.Tokens[0].Value;
        if (NumberPrompt.TryNumber(word, out var value) && Math.Abs(value) <= Largest && allowed(value)) return value;
        result.AddError(Wording.Get("OptionValue.Invalid", Name(result), word, wanted));
        return double.NaN;
    }


    private static string Name(ArgumentResult result) => result.Argument.Name;
}
