using Engraver.Core.Machines;
using Engraver.Core.Motion;
using Engraver.Galil.Driver;
using Engraver.Links.Serial;

namespace Engraver.Workbench.Composition;

/// <summary>A family of controllers that this workbench drives.</summary>
/// <param name="Driver">The family's driver, which answers for it while no controller is connected.</param>
/// <param name="Takes">Whether an address may be one of its controllers.</param>
/// <param name="WhyNot">Why such an address cannot be used on this system; null where it can.</param>
/// <param name="Connect">How a machine at such an address is reached; true asks a simulated one to keep its record, the profile says where its switches
/// lie.</param>
public sealed record MachineFamily(
    IMachineDriver Driver, Func<ControllerAddress, bool> Takes, Func<ControllerAddress, string?> WhyNot, Func<ControllerAddress, TimeProvider, bool, MachineProfile?, MachineConnection> Connect);

/// <summary>Every family: a new one is its driver and one line here.</summary>
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

    /// <summary>The driver by which jobs are prepared: that of the first family.</summary>
    public static IMachineDriver Driver => All[0].Driver;

    /// <summary>The family that is reached at an address.</summary>
    /// <exception cref="ArgumentException">None is.</exception>
    public static MachineFamily Of(ControllerAddress address) => All.FirstOrDefault(family => family.Takes(address)) ?? throw new ArgumentException($"No family of controllers is reached at {address}.", nameof(address));
}
