using System.Diagnostics;
using Engraver.Core.Machines;
using Engraver.Galil.Driver;
using Engraver.Galil.Sessions;
using Engraver.Links.Serial;

namespace Engraver.Workbench.Composition;

/// <summary>The DMC family: over the network, over a serial line, or a simulated controller.</summary>
internal static class GalilFamily
{
    public static GalilDriver Driver { get; } = new();

    public static MachineFamily Create() => new()
    {
        Driver = Driver,
        Accepts = address => address is TcpAddress or SerialAddress or SimulatedAddress,
        RefusalOf = address => address is SerialAddress serial ? SerialLink.WhyUnsupported(serial) : null,
        Connect = (address, time, keepsRecord, profile) => address switch
        {
            TcpAddress tcp => MachineConnection.OverNetwork(Driver, tcp, time, () => ControllerSession.HandlesTaken),
            SerialAddress serial => MachineConnection.OverSerialLine(Driver, serial, time),
            SimulatedAddress simulated => MachineConnection.Simulated(Driver, simulated, time, keepsRecord, profile),
            _ => throw new UnreachableException(),
        },
    };
}
