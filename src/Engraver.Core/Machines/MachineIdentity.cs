namespace Engraver.Core.Machines;

/// <summary>Who answers on the link.</summary>
/// <param name="Model">As the controller names itself.</param>
/// <param name="Axes">How many it has.</param>
public record MachineIdentity(string Model, int Axes);
