using System.Globalization;

namespace Engraver.Core.Machines;

/// <summary>The rates of machining, in any currency.</summary>
/// <param name="PerHour">Per hour of the whole job's time.</param>
/// <param name="PerMetre">Per metre of cut length.</param>
/// <param name="PerStart">Per started stroke: a hole and a threaded wire, a pierced sheet.</param>
public sealed record JobRates(double PerHour, double PerMetre = 0.0, double PerStart = 0.0)
{
    /// <summary>Parses one to three numbers of 0 or more, separated by commas; null for anything else.</summary>
    public static JobRates? Parse(string text)
    {
        ArgumentNullException.ThrowIfNull(text);
        var (words, numbers) = (text.Split(','), new double[3]);
        if (words.Length > numbers.Length) return null;
        for (var i = 0; i < words.Length; i++)
        {
            if (!double.TryParse(words[i], NumberStyles.AllowDecimalPoint, CultureInfo.InvariantCulture, out numbers[i]) || !double.IsFinite(numbers[i])) return null;
        }

        return new JobRates(numbers[0], numbers[1], numbers[2]);
    }

    /// <param name="seconds">Time of the whole job.</param>
    /// <param name="cutLength">Millimetres.</param>
    /// <param name="starts">Number of strokes.</param>
    public JobCost CostOf(double seconds, double cutLength, int starts) => new(PerHour * seconds / 3600.0, PerMetre * cutLength / 1000.0, PerStart * starts);
}
