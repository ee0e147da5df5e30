namespace Engraver.Core.Sequencing.Ordering.Optimising;

/// <summary>How one axis of the machine moves between strokes: from rest to rest, with the same acceleration and deceleration.</summary>
/// <param name="Speed">Rapid speed, mm/s; above 0.</param>
/// <param name="Acceleration">mm/s2; above 0.</param>
public readonly record struct AxisRapid(double Speed, double Acceleration)
{
    /// <summary>Distance from which the rapid speed is reached, mm.</summary>
    public double RampDistance { get; } = Speed * Speed / Acceleration;

    private readonly double _rampSeconds = Speed / Acceleration;
    private readonly double _secondsPerMm = 1.0 / Speed;
    private readonly double _triangle = 4.0 / Acceleration;

    /// <summary>Seconds for a distance.</summary>
    /// <param name="distance">Millimetres, from 0.</param>
    public double Seconds(double distance) => distance >= RampDistance ? (distance * _secondsPerMm) + _rampSeconds : Math.Sqrt(distance * _triangle);
}
