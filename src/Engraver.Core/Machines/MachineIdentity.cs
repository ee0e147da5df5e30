namespace Engraver.Core.Machines;

/// <summary>The controller that answers on the link.</summary>
/// <param name="Model">As the controller names itself.</param>
/// <param name="Axes">Number of axes.</param>
public record MachineIdentity(string Model, int Axes)
{
    /// <summary>Its family, where no simulated controller is of it: nothing was tried on one. Null where one is.</summary>
    public string? UntriedFamily { get; init; }
}
