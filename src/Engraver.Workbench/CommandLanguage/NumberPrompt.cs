using System.Globalization;
using Engraver.Core;
using Engraver.Core.Geometry;

namespace Engraver.Workbench.CommandLanguage;

/// <summary>Asks for a number between two limits (both allowed).</summary>
public sealed record NumberPrompt(string Instruction) : ValuePrompt<double>(Instruction)
{
    public double Min { get; init; } = double.MinValue;

    public double Max { get; init; } = double.MaxValue;

    public bool IsInteger { get; init; }

    public override ParsedInput<double> Parse(string typed, Point2D lastPoint)
    {
        if (!TryParse(typed, out var value)) return new ParsedInput<double>.Invalid(Wording.Get("NumberPrompt.NotANumber", typed));
        if (IsInteger && value != Math.Floor(value)) return new ParsedInput<double>.Invalid(Wording.Get("NumberPrompt.NotAWholeNumber", typed));
        return value >= Min && value <= Max ? new ParsedInput<double>.Value(value) : new ParsedInput<double>.Invalid(RangeMessage(typed));
    }

    private string RangeMessage(string typed) => Max == double.MaxValue
        ? Wording.Get("NumberPrompt.TooSmall", typed, Min)
        : Wording.Get("NumberPrompt.OutOfRange", typed, Min, Max);

    /// <summary>Parses a finite number with a decimal point in any culture.</summary>
    public static bool TryParse(string typed, out double value) =>
        double.TryParse(typed, NumberStyles.Float & ~NumberStyles.AllowLeadingWhite & ~NumberStyles.AllowTrailingWhite, CultureInfo.InvariantCulture, out value) && double.IsFinite(value);

    public static string Format(double value) => NumberText.Rounded(value, 10);
}
