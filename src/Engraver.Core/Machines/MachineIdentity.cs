namespace Engraver.Core.Machines;

/// <summary>The controller that answers on the link.</summary>
/// <param name="Model">As the controller names itself.</param>
/// <param name="Axes">Number of axes.</param>
public record MachineIdentity(string Model, int Axes);
