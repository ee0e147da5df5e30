namespace Engraver.Core.Machines.Setup;

/// <summary>The level of an input that counts as active.</summary>
public enum SwitchSense
{
    /// <summary>A switch closed to ground, the factory default of a controller.</summary>
    Low,

    /// <summary>An open switch: normally closed switches, where a broken wire is detected.</summary>
    High,
}
