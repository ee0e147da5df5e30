using System.Diagnostics;
using System.Globalization;
using Engraver.Core.Machines;
using Engraver.Galil.Driver;
using Engraver.Galil.Sessions;
using Engraver.Galil.Terminals;
using Engraver.Links;
using Engraver.Links.Serial;
using Engraver.Simulator;

namespace Engraver.Workbench.Composition;

/// <summary>How links to one machine are opened: over the network, over a serial line, or to a simulated controller that lives in this process and is owned
/// here.</summary>
public sealed class MachineConnection : IAsyncDisposable
{
    /// <summary>Serial number of every simulated controller in this process; it is always the same, so that the records of equal runs are equal.</summary>
    internal const int SimulatedSerialNumber = 2143;

    private static readonly TimeSpan s_connectTimeout = TimeSpan.FromSeconds(5);
    private static readonly TimeSpan s_writeTimeout = TimeSpan.FromSeconds(2);
    private readonly Func<CancellationToken, Task<IControllerLink>> _open;
    private readonly Func<MachineClock> _takeClock;

    private MachineConnection(string description, SimulatedController? simulator, Func<CancellationToken, Task<IControllerLink>> open, Func<MachineClock> takeClock)
    {
        Description = description;
        Simulator = simulator;
        _open = open;
        _takeClock = takeClock;
    }

    public string Description { get; }

    /// <summary>The simulated controller of a <c>sim:</c> address; null for a real link.</summary>
    public SimulatedController? Simulator { get; }

    /// <exception cref="PlatformNotSupportedException">A serial link on a machine for which it is not built; thrown when the link is opened.</exception>
    /// <param name="keepsRecord">Whether a simulated controller keeps its record to be read afterwards; listeners get the motion in either case.</param>
    /// <param name="profile">Where the switches of a simulated machine lie; null: it has none.</param>
    public static MachineConnection To(ControllerAddress address, TimeProvider time, bool keepsRecord = false, MachineProfile? profile = null) => MachineFamilies.Of(address).Connect(address, time, keepsRecord, profile);

    /// <summary>The entry of the DMC family.</summary>
    internal static MachineConnection ToGalil(ControllerAddress address, TimeProvider time, bool keepsRecord, MachineProfile? profile) => address switch
    {
        TcpAddress tcp => new MachineConnection(
            $"tcp://{tcp.Host}:{tcp.Port}",
            simulator: null,
            async cancellation => await TcpLink.ConnectAsync(tcp.Host, tcp.Port, s_connectTimeout, time, cancellation, () => ControllerSession.HandlesTaken).ConfigureAwait(false),
            () => Offered(tcp, time)),
        SerialAddress serial => new MachineConnection(
            $"serial://{serial.Device}",
            simulator: null,
            _ => Task.FromResult<IControllerLink>(SerialLink.Open(serial, s_writeTimeout, time)),
            () => Offered(serial, time)),
        SimulatedAddress simulated => Simulate(simulated, time, keepsRecord, profile),
        _ => throw new UnreachableException(),
    };

    /// <summary>A machine whose links are opened by a function of the caller.</summary>
    /// <param name="description">Where it is, for people and for the journal.</param>
    internal static MachineConnection Through(string description, Func<CancellationToken, Task<IControllerLink>> open, Func<MachineClock> takeClock) => new(description, simulator: null, open, takeClock);

    /// <summary>Opens one more link (one more handle of the controller).</summary>
    public Task<IControllerLink> OpenLinkAsync(CancellationToken cancellation) => _open(cancellation);

    /// <summary>Opens a conversation line by line.</summary>
    /// <exception cref="ControllerException">The link never came up.</exception>
    public async Task<IMachineTerminal> OpenTerminalAsync(TimeProvider time, CancellationToken cancellation) => await MachineTerminal.OpenAsync(OpenLinkAsync, time, cancellation).ConfigureAwait(false);

    /// <summary>Shakes hands over links of its own, by the wall's clock or another: for those who look and do not run a job
    /// (<see cref="MachineClock"/>).</summary>
    /// <exception cref="ControllerException">Nobody answers.</exception>
    public async Task<IMachineConnection> ShakeHandsAsync(TimeProvider time, CancellationToken cancellation) =>
        await GalilConnection.OpenAsync(OpenLinkAsync, trace: null, time, cancellation).ConfigureAwait(false);

    /// <summary>The clock for a job. A simulated controller gives its own, one of another process if it is not at speed 1: its time then goes on only by
    /// what the job says and while the job waits, until the clock is disposed.</summary>
    /// <exception cref="ControllerLinkException">Nobody offers a clock where the address says.</exception>
    public MachineClock TakeClock() => _takeClock();

    public ValueTask DisposeAsync() => Simulator?.DisposeAsync() ?? ValueTask.CompletedTask;

    private static MachineConnection Simulate(SimulatedAddress address, TimeProvider time, bool keepsRecord, MachineProfile? profile)
    {
        var controller = new SimulatedController(new SimulatorOptions { Speed = address.Speed, Time = time, KeepsRecord = keepsRecord, SerialNumber = SimulatedSerialNumber, Switches = profile is null ? [] : SimulatedMachine.Switches(profile) });
        return new MachineConnection(
            double.IsPositiveInfinity(address.Speed) ? "sim:" : string.Create(CultureInfo.InvariantCulture, $"sim:?speed={address.Speed}"),
            controller,
            _ => Task.FromResult<IControllerLink>(LinkTo(controller)),
            () => MachineClock.FromSimulator(controller.JoinClock()));
    }

    private static StreamLink LinkTo(SimulatedController controller)
    {
        var taken = 0L;
        return new StreamLink(controller.OpenConnection(ticks => Volatile.Write(ref taken, ticks)), "sim:") { Taken = () => Volatile.Read(ref taken), Now = () => controller.ClockTicks };
    }

    private static MachineClock Offered(ControllerAddress address, TimeProvider wall) => address.ClockPort is { } port ? MachineClock.FromOffer(OfferedClock.Take(port)) : MachineClock.FromWall(wall);
}
