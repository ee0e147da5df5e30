using Engraver.Core.Geometry;

namespace Engraver.Galil.Programs.Generation;

/// <summary>How the controller quantizes an angle: four decimals in the text, truncated to 1/65536 like every number (0.6 becomes 0.59999), then to the steps
/// of CR (galil-dmc.md B.3, E).</summary>
/// <param name="Degrees">The controller's step, 1/65536 or, in older manuals, 1/256 degree.</param>
public readonly record struct AngleQuantum(double Degrees)
{
    private const decimal NumberSteps = 65536;
    private const int DecimalsInText = 4;

    /// <summary>The angle that the controller uses when this one is sent. On a circle of 700,000 counts one step is a fifth of a count, and errors add up along
    /// a chain of arcs.</summary>
    public double Quantize(double degrees)
    {
        var text = Math.Round((decimal)degrees, DecimalsInText, MidpointRounding.AwayFromZero);
        var number = (double)(decimal.Truncate(text * NumberSteps) / NumberSteps);
        return Math.Round(number / Degrees, MidpointRounding.AwayFromZero) * Degrees;
    }

    /// <summary>The same for a direction: 0 or more, and less than 360.</summary>
    public double QuantizeDirection(double degrees) => Quantize(Angle.FromDegrees(degrees).Positive().Degrees) is var kept && kept >= 360.0 ? kept - 360.0 : kept;
}
