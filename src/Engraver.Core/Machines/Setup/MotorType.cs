namespace Engraver.Core.Machines.Setup;

/// <summary>The signal sent to the drive of an axis.</summary>
/// <param name="IsReversed">The other sense of rotation.</param>
public readonly record struct MotorType(MotorSignal Signal, bool IsReversed);
