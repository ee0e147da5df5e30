namespace Engraver.Core.Machines;

/// <summary>An axis that does not move and whose analog output sets the power of a beam.</summary>
/// <param name="Axis">Its letter.</param>
/// <param name="Volts">Volts at full power (galil-dmc.md C, OF: -9.9982 to 9.9982).</param>
public sealed record AnalogOutput(char Axis, double Volts);
