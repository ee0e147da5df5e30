namespace Engraver.Simulator.Motion;

/// <summary>One sample of a trapezoid: speeds in counts/s, accelerations in counts/s2, lengths in counts, times in seconds.</summary>
internal static class Ramp
{
    /// <summary>The nominal sample (TM 1000).</summary>
    public const double Sample = 0.001;

    /// <summary>Speed after <paramref name="dt"/> towards a commanded speed.</summary>
    public static double Towards(double speed, double commanded, double acceleration, double deceleration, double dt) =>
        commanded > speed
            ? Math.Min(commanded, speed + (acceleration * dt))
            : Math.Max(commanded, speed - (deceleration * dt));

    /// <summary>
    /// Largest speed after <paramref name="dt"/> from which <paramref name="endSpeed"/> can still be reached over the remaining length:
    /// v1^2 = p^2 + 2 d (R - (v + v1) dt / 2), solved for v1. On the braking parabola this is exactly v - d dt; beyond its end it continues below p.
    /// </summary>
    public static double Braking(double speed, double remaining, double endSpeed, double deceleration, double dt)
    {
        var step = deceleration * dt;
        var square = (step * step) + (4 * ((endSpeed * endSpeed) + (2 * deceleration * remaining) - (step * speed)));
        return square <= 0 ? -step : (Math.Sqrt(square) - step) / 2;
    }
}
