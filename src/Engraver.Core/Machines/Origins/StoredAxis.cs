namespace Engraver.Core.Machines.Origins;

/// <param name="Counts">Per millimetre; negative where the axis counts downwards.</param>
/// <param name="Letter">The controller's letter of the axis; null where it is unknown.</param>
public readonly record struct StoredAxis(double Counts, char? Letter);
