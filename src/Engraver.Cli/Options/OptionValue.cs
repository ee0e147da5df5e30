using System.CommandLine.Parsing;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Settings;

namespace Engraver.Cli.Options;

/// <summary>Reads the values of options: invariant numbers only, and one sentence when a value cannot be read.</summary>
internal static class OptionValue
{
    public static double PositiveNumber(ArgumentResult result) => Number(result, TypedNumber.AboveZero);

    public static double NumberFromZero(ArgumentResult result) => Number(result, TypedNumber.FromZero);

    public static double AnyNumber(ArgumentResult result) => Number(result, _ => true, Wording.Get("OptionValue.AnyNumber"));

    /// <summary>A whole number from 1 to a million.</summary>
    public static double IntegerFromOne(ArgumentResult result) => Number(result, value => value is >= 1.0 and <= 1e6 && value == Math.Floor(value), Wording.Get("OptionValue.WholeNumberFromOne"));

    public static double NumberFromOne(ArgumentResult result) => Number(result, value => value >= 1.0, Wording.Get("OptionValue.NumberFromOne"));

    /// <summary>Seconds above 0, at most a day.</summary>
    public static double SecondsOfADay(ArgumentResult result) => Number(result, value => value is > 0.0 and <= 86_400.0, Wording.Get("OptionValue.SecondsUpToADay"));

    /// <summary>Seconds from 0, at most a day.</summary>
    public static double SecondsFromZero(ArgumentResult result) => Number(result, value => value is >= 0.0 and <= 86_400.0, Wording.Get("OptionValue.SecondsFromZero"));

    /// <summary>Mm/min above 0 and below a million.</summary>
    public static double Speed(ArgumentResult result) => Number(result, value => value is > 0.0 and < 1e6, Wording.Get("OptionValue.Speed"));

    /// <summary>Above 0 and below 1.</summary>
    public static double NumberBelowOne(ArgumentResult result) => Number(result, value => value is > 0.0 and < 1.0, Wording.Get("OptionValue.NumberBelowOne"));

    /// <summary>Degrees above 0 and below 90.</summary>
    public static double RampAngle(ArgumentResult result) => Number(result, value => value is > 0.0 and < 90.0, Wording.Get("OptionValue.RampAngle"));

    private static double Number(ArgumentResult result, Func<string, ParsedInput<double>> read)
    {
        var reading = read(result.Tokens[0].Value);
        if (reading is ParsedInput<double>.Invalid wrong) result.AddError($"{Name(result)}: {wrong.Message}");
        return reading is ParsedInput<double>.Value value ? value.Result : double.NaN;
    }

    private static double Number(ArgumentResult result, Func<double, bool> allowed, string wanted)
    {
        var word = result.Tokens[0].Value;
        if (NumberPrompt.TryParse(word, out var value) && Math.Abs(value) <= TypedNumber.Largest && allowed(value)) return value;
        result.AddError(Wording.Get("OptionValue.Invalid", Name(result), word, wanted));
        return double.NaN;
    }

    private static string Name(ArgumentResult result) => result.Argument.Name;
}
