namespace Engraver.Galil.Programs;

/// <summary>What becomes of an angle on its way into the controller: four decimals in the text, then the steps in which the controller holds it (galil-dmc.md B.3).</summary>
/// <param name="Degrees">The controller's step, 1/65536 or, in older manuals, 1/256 degree.</param>
public readonly record struct AngleQuantum(double Degrees)
{
    private const int DecimalsInText = 4;

    /// <summary>The angle that the controller keeps when it is sent this one.</summary>
    public double Keep(double degrees) =>
        Math.Round(Math.Round(degrees, DecimalsInText, MidpointRounding.AwayFromZero) / Degrees, MidpointRounding.AwayFromZero) * Degrees;
}
