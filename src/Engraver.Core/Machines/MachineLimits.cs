namespace Engraver.Core.Machines;

/// <summary>What a family of controllers accepts, in its own units; its driver states it, so that a profile is refused before anything is generated from
/// it.</summary>
/// <param name="SlowestSpeed">Counts/s of an axis.</param>
/// <param name="FastestSpeed">Counts/s of an axis.</param>
/// <param name="AccelerationStep">Accelerations are multiples of this, counts/s2; it is also the smallest acceleration.</param>
/// <param name="LargestAcceleration">Counts/s2.</param>
/// <param name="Outputs">Digital outputs, counted from 1.</param>
/// <param name="Axes">The letters that an axis may have.</param>
public sealed record MachineLimits(int SlowestSpeed, int FastestSpeed, int AccelerationStep, int LargestAcceleration, int Outputs, string Axes)
{
    /// <summary>The numbers that a motor type may have; empty where the family has none.</summary>
    public IReadOnlyList<double> MotorTypes { get; init; } = [];

    /// <summary>Largest analog output of an axis, volts.</summary>
    public double LargestVolts { get; init; }
}
