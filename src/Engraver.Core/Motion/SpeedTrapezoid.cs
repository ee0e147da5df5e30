namespace Engraver.Core.Motion;

/// <summary>Speed over time for a distance from rest to rest with the same acceleration and deceleration; a triangle when the distance is short. Any unit of
/// length.</summary>
public readonly record struct SpeedTrapezoid(double Distance, double TopSpeed, double Acceleration)
{
    /// <summary>The speed that is reached.</summary>
    public double Peak => Math.Min(TopSpeed, Math.Sqrt(Distance * Acceleration));

    /// <summary>Seconds from rest to <see cref="Peak"/>, and again from it to rest.</summary>
    public double RampSeconds => Peak / Acceleration;

    public double Seconds => Time(Distance, TopSpeed, Acceleration);

    /// <summary>Distance covered after this time; between 0 and <see cref="Distance"/>.</summary>
    public double DistanceAt(double seconds)
    {
        if (seconds <= 0.0) return 0.0;
        var left = Seconds - seconds;
        if (left <= 0.0) return Distance;
        var (ramp, peak) = (RampSeconds, Peak);
        if (seconds < ramp) return 0.5 * Acceleration * seconds * seconds;
        return left < ramp ? Distance - (0.5 * Acceleration * left * left) : (0.5 * peak * ramp) + (peak * (seconds - ramp));
    }

    public double SpeedAt(double seconds) => Math.Clamp(Math.Min(Acceleration * seconds, Acceleration * (Seconds - seconds)), 0.0, Peak);

    /// <summary>Seconds until this distance is covered.</summary>
    public double TimeAt(double distance)
    {
        if (distance <= 0.0) return 0.0;
        var left = Distance - distance;
        if (left <= 0.0) return Seconds;
        var (ramp, peak) = (RampSeconds, Peak);
        var rampDistance = 0.5 * peak * ramp;
        if (distance < rampDistance) return Math.Sqrt(2.0 * distance / Acceleration);
        return left < rampDistance ? Seconds - Math.Sqrt(2.0 * left / Acceleration) : ramp + ((distance - rampDistance) / peak);
    }

    /// <summary>Seconds for a distance at a speed with the same acceleration and deceleration; a triangle when the distance is short.</summary>
    public static double Time(double distance, double speed, double acceleration) => distance >= speed * speed / acceleration
        ? (distance / speed) + (speed / acceleration)
        : 2.0 * Math.Sqrt(distance / acceleration);
}
