using System.Globalization;
using Engraver.Core;
using Engraver.Core.Geometry;

namespace Engraver.Workbench.CommandLanguage;

/// <summary>Asks for a number between two limits (both allowed).</summary>
public sealed record NumberPrompt(string Instruction) : ValuePrompt<double>(Instruction)
{
    public double Least { get; init; } = double.MinValue;

    public double Most { get; init; } = double.MaxValue;

    public bool Whole { get; init; }

    public override Reading<double> Read(string typed, Point2D lastPoint)
    {
        if (!TryNumber(typed, out var value)) return new Reading<double>.Wrong(Wording.Get("NumberPrompt.NotANumber", typed));
        if (Whole && value != Math.Floor(value)) return new Reading<double>.Wrong(Wording.Get("NumberPrompt.NotAWholeNumber", typed));
        return value >= Least && value <= Most ? new Reading<double>.Value(value) : new Reading<double>.Wrong(WhyNot(typed));
    }

    private string WhyNot(string typed) => Most == double.MaxValue
        ? Wording.Get("NumberPrompt.TooSmall", typed, Least)
        : Wording.Get("NumberPrompt.OutOfRange", typed, Least, Most);

    /// <summary>Parses a finite number with a decimal point in any culture.</summary>
    public static bool TryNumber(string typed, out double value) =>
        double.TryParse(typed, NumberStyles.Float & ~NumberStyles.AllowLeadingWhite & ~NumberStyles.AllowTrailingWhite, CultureInfo.InvariantCulture, out value) && double.IsFinite(value);

    public static string Show(double value) => NumberText.Rounded(value, 10);
}
