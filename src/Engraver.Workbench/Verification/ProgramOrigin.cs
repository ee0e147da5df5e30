using System.Globalization;
using Engraver.Core.Machines;

namespace Engraver.Workbench.Verification;

/// <summary>Position of the drawing's zero in a program, mm relative to the controller's zero.</summary>
/// <param name="Z">Null: the tool height at the start of the program.</param>
public sealed record ProgramOrigin(double X, double Y, double? Z)
{
    /// <summary>Parses two or three finite numbers separated by commas; null for any other text.</summary>
    public static ProgramOrigin? TryParse(string text)
    {
        ArgumentNullException.ThrowIfNull(text);
        var numbers = text.Split(',').Select(word => double.TryParse(word, NumberStyles.AllowDecimalPoint | NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out var number) ? number : double.NaN).ToList();
        if (!numbers.TrueForAll(double.IsFinite)) return null;
        return numbers switch
        {
            [var x, var y] => new ProgramOrigin(x, y, null),
            [var x, var y, var z] => new ProgramOrigin(x, y, z),
            _ => null,
        };
    }

    /// <summary>Position of the controller's zero in the frame of the drawing, counts.</summary>
    internal CountsPoint StartCounts(CountsScale scale) => new(Counts(scale.X.Exact(-X)), Counts(scale.Y.Exact(-Y)), (int)Math.Clamp(Counts(scale.Z.Exact(-(Z ?? 0.0))), int.MinValue, int.MaxValue));

    /// <summary>Time of the rapid from the controller's zero to the drawing's.</summary>
    internal TimeSpan RapidTime(MachineProfile machine) => TimeSpan.FromMinutes((Math.Abs(X) + Math.Abs(Y) + Math.Abs(Z ?? 0.0)) / machine.RapidMmPerMinute);

    private static long Counts(double value) => (long)Math.Clamp(Math.Round(value), -CountsScale.MaxCounts, CountsScale.MaxCounts);
}
