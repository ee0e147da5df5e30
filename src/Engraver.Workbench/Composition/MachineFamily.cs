using Engraver.Core.Machines;
using Engraver.Core.Motion;
using Engraver.Galil.Driver;
using Engraver.Galil.Links;

namespace Engraver.Workbench.Composition;

/// <summary>A supported controller family.</summary>
/// <param name="Driver">The driver, also used while no controller is connected.</param>
/// <param name="Takes">Whether an address may belong to this family.</param>
/// <param name="WhyNot">Why such an address cannot be used on this system; null if it can.</param>
/// <param name="Connect">Creates the connection to an address; true makes a simulated controller store its record, the profile defines its switches.</param>
public sealed record MachineFamily(
    IMachineDriver Driver, Func<ControllerAddress, bool> Takes, Func<ControllerAddress, string?> WhyNot, Func<ControllerAddress, TimeProvider, bool, MachineProfile?, MachineConnection> Connect);

/// <summary>All families. A new family adds one line.</summary>
public static class MachineFamilies
{
    public static IReadOnlyList<MachineFamily> All { get; } =
    [
        new(
            new GalilDriver(),
            address => address is TcpAddress or SerialAddress or SimulatedAddress,
            address => address is SerialAddress ? SerialLink.WhyUnsupported : null,
            MachineConnection.ToGalil),
    ];

    /// <summary>The driver used to prepare jobs: that of the first family.</summary>
    public static IMachineDriver Driver => All[0].Driver;

    /// <summary>The family of an address.</summary>
    /// <exception cref="ArgumentException">There is none.</exception>
    public static MachineFamily Of(ControllerAddress address) => All.FirstOrDefault(family => family.Takes(address)) ?? throw new ArgumentException($"No family of controllers is reached at {address}.", nameof(address));
}
