using Engraver.Core.Machines;
using Engraver.Core.Motion;

namespace Engraver.Workbench.Composition;

/// <summary>A family of controllers that this workbench drives: its driver, and how its machines are reached.</summary>
public sealed record MachineFamily
{
    /// <summary>Answers for the family while no controller is connected, and identifies one at the other end of a link.</summary>
    public required IMachineDriver Driver { get; init; }

    /// <summary>Whether an address may be one of its controllers.</summary>
    public required Func<ControllerAddress, bool> Accepts { get; init; }

    /// <summary>How a machine at such an address is reached. True asks a simulated one to keep its record; the profile states where the switches of a simulated
    /// machine are, null for a machine without switches.</summary>
    public required Func<ControllerAddress, TimeProvider, bool, MachineProfile?, MachineConnection> Connect { get; init; }

    /// <summary>Why such an address cannot be used on this system; null where it can.</summary>
    public Func<ControllerAddress, string?> RefusalOf { get; init; } = _ => null;

    /// <summary>Parses a form of address that only this family has; null for any other text.</summary>
    public Func<string, ControllerAddress?> ParseAddress { get; init; } = _ => null;

    /// <summary>Its own forms of address, for messages; empty for none.</summary>
    public IReadOnlyList<string> AddressForms { get; init; } = [];
}
