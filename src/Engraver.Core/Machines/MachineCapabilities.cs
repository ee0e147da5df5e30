namespace Engraver.Core.Machines;

/// <summary>What a connection can do. A capability that is null does not exist, so a caller can check it instead of calling a method that throws.</summary>
/// <param name="IsSingleWire">All traffic uses one connection: the machine cannot be observed during a job.</param>
/// <param name="Jog">Motion while a key is held; null where it is not offered.</param>
/// <param name="Hold">A job can be held and resumed; null where it is not offered.</param>
/// <param name="Override">The feed of a running job can be changed; null where it is not offered.</param>
public sealed record MachineCapabilities(bool IsSingleWire, SpeedRange? Jog = null, HoldCapability? Hold = null, SpeedRange? Override = null);
