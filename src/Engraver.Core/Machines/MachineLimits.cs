namespace Engraver.Core.Machines;

/// <summary>What a family of controllers accepts, in its own units. The driver provides it, so that a profile outside it is refused before anything is generated.</summary>
/// <param name="SlowestSpeed">Counts/s of an axis.</param>
/// <param name="FastestSpeed">Counts/s of an axis.</param>
/// <param name="AccelerationStep">Accelerations are multiples of this, counts/s2; it is also the smallest acceleration.</param>
/// <param name="LargestAcceleration">Counts/s2.</param>
/// <param name="Outputs">Number of digital outputs; the first is 1.</param>
public sealed record MachineLimits(int SlowestSpeed, int FastestSpeed, int AccelerationStep, int LargestAcceleration, int Outputs);
