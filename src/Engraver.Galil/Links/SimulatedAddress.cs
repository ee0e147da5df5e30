namespace Engraver.Galil.Links;

/// <param name="Speed">Controller seconds per wall second; infinity is virtual time.</param>
public sealed record SimulatedAddress(double Speed) : ControllerAddress
{
    /// <summary>False for a bare <c>sim:</c>: whoever connects may have a speed of its own in mind; the console has none.</summary>
    public bool SaysSpeed { get; init; } = true;
}
