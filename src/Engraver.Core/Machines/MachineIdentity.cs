namespace Engraver.Core.Machines;

/// <summary>The controller that replies on the link.</summary>
/// <param name="Model">The controller's own name for its model.</param>
/// <param name="Axes">Number of axes.</param>
public record MachineIdentity(string Model, int Axes)
{
    /// <summary>Its family, where no simulated controller belongs to it, so that nothing was tried on one. Null where one does.</summary>
    public string? UntriedFamily { get; init; }
}
