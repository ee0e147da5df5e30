namespace Engraver.Core.Dxf.Mapping;

/// <summary>The turn from one angle to another, counter-clockwise.</summary>
/// <param name="Sweep">0 for equal angles, a whole turn for angles that differ by whole turns, otherwise between them.</param>
/// <param name="IsWrapped">True when the angles differ by more than a turn and not by whole turns; the whole turns are then left out.</param>
internal readonly record struct TurnSpan(double Sweep, bool IsWrapped)
{
    /// <summary>Angles that differ by whole turns within this tolerance make a whole turn, or no turn when they are equal.</summary>
    private const double Equal = 1e-9;

    /// <summary>Programs round 2 pi up (6.28318531, 360.000001): the part of a turn, 0.001 rad, by which a difference may exceed whole turns.</summary>
    private const double Excess = 1e-3 / Math.Tau;

    /// <summary>From start to end, <paramref name="turn"/> being 360 or 2 pi.</summary>
    public static TurnSpan Between(double start, double end, double turn)
    {
        var difference = end - start;
        if (Math.Abs(difference) <= Equal) return default;
        var sweep = difference % turn;
        if (sweep < 0.0) sweep += turn;
        var slack = difference >= turn ? Excess * turn : Equal;
        var isWhole = sweep >= turn - Equal || (Math.Abs(difference) >= turn - Equal && sweep <= slack);
        return isWhole ? new TurnSpan(turn, false) : new TurnSpan(sweep, Math.Abs(difference) > turn);
    }
}
