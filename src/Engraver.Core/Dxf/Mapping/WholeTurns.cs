namespace Engraver.Core.Dxf.Mapping;

/// <summary>The turn from one angle to another, as a record has the two: 0 for equal angles, a whole turn for angles that are whole turns apart.</summary>
internal static class WholeTurns
{
    /// <summary>Angles that differ by less are equal, or a whole turn apart.</summary>
    private const double Tolerance = 1e-9;

    /// <summary>Radians by which a span may be larger than whole turns and still mean one: 2 pi rounded to two decimals or more, 360 degrees to one.</summary>
    /// <remarks>Writers round the end angle: a span that is a little too large never means an arc of that little.</remarks>
    private const double Rounding = 1e-3;

    /// <summary>Counter-clockwise from start to end, 0 to <paramref name="turn"/> (360 or 2 pi).</summary>
    public static double Sweep(double start, double end, double turn)
    {
        var span = end - start;
        if (Math.Abs(span) <= Tolerance) return 0.0;
        if (IsWhole(span, turn)) return turn;
        var sweep = span % turn;
        if (sweep < 0.0) sweep += turn;
        return sweep <= Tolerance || sweep >= turn - Tolerance ? turn : sweep;
    }

    /// <summary>The span is larger than a turn by more than rounding explains: what is drawn is what is left beyond the turns, and nobody can be sure that it was meant.</summary>
    public static bool IsBeyond(double start, double end, double turn) => Math.Abs(end - start) > turn + Tolerance && Sweep(start, end, turn) != turn;

    private static bool IsWhole(double span, double turn) => span >= turn && span % turn <= Rounding * turn / Math.Tau;
}
