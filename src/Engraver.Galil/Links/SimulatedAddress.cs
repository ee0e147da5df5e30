namespace Engraver.Galil.Links;

/// <param name="Speed">Controller seconds per wall second; infinity is virtual time.</param>
public sealed record SimulatedAddress(double Speed) : ControllerAddress;
