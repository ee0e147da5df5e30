namespace Engraver.Galil.Programs;

/// <summary>What becomes of an angle on its way into the controller: four decimals in the text, cut off at 1/65536 like every number (0.6 becomes 0.59999), then the steps in which CR holds it (galil-dmc.md B.3, E).</summary>
/// <param name="Degrees">The controller's step, 1/65536 or, in older manuals, 1/256 degree.</param>
public readonly record struct AngleQuantum(double Degrees)
{
    private const decimal NumberSteps = 65536;
    private const int DecimalsInText = 4;

    /// <summary>The angle that the controller keeps when it is sent this one. On a circle of 700,000 counts one such step is a fifth of a count, and a chain of arcs adds them up.</summary>
    public double Keep(double degrees)
    {
        var text = Math.Round((decimal)degrees, DecimalsInText, MidpointRounding.AwayFromZero);
        var number = (double)(decimal.Truncate(text * NumberSteps) / NumberSteps);
        return Math.Round(number / Degrees, MidpointRounding.AwayFromZero) * Degrees;
    }
}
