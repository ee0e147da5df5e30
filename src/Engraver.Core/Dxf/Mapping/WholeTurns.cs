namespace Engraver.Core.Dxf.Mapping;

/// <summary>The turn from one angle to another, degrees: 0 for equal angles, 360 for angles that differ by whole turns.</summary>
internal static class WholeTurns
{
    /// <summary>Angles that differ by whole turns within this make a whole turn, or none when they are equal.</summary>
    private const double Tolerance = 1e-9;

    /// <summary>Counter-clockwise from start to end, 0 to <paramref name="turn"/> (360 or 2 pi).</summary>
    public static double Sweep(double start, double end, double turn)
    {
        var difference = end - start;
        if (Math.Abs(difference) <= Tolerance) return 0.0;
        var sweep = difference % turn;
        if (sweep < 0.0) sweep += turn;
        return sweep <= Tolerance || sweep >= turn - Tolerance ? turn : sweep;
    }
}
