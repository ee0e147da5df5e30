namespace Engraver.Simulator;

/// <summary>The error in a fault.</summary>
/// <param name="Field">Name of the field in a faults file.</param>
public readonly record struct FaultError(string Field, FaultErrorReason Reason);
