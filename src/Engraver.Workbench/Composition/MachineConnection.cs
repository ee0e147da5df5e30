using System.Diagnostics;
using System.Globalization;
using Engraver.Core.Machines;
using Engraver.Galil.Driver;
using Engraver.Galil.Links;
using Engraver.Galil.Terminals;
using Engraver.Simulator;

namespace Engraver.Workbench.Composition;

/// <summary>How links to one machine are opened: over the network, over a serial line, or to a simulated controller in this process, which this object
/// owns.</summary>
public sealed class MachineConnection : IAsyncDisposable
{
    /// <summary>Serial number of every simulated controller in this process; constant, so that equal runs give equal records.</summary>
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

    /// <exception cref="PlatformNotSupportedException">Serial links are not supported on this system; thrown when the link is opened.</exception>
    /// <param name="keepsRecord">Whether a simulated controller stores its record; listeners receive the motion in any case.</param>
    /// <param name="profile">Switch positions of a simulated machine; null: it has none.</param>
    public static MachineConnection To(ControllerAddress address, TimeProvider time, bool keepsRecord = false, MachineProfile? profile = null) => MachineFamilies.Of(address).Connect(address, time, keepsRecord, profile);

    /// <summary>The entry of the DMC family.</summary>
    internal static MachineConnection ToGalil(ControllerAddress address, TimeProvider time, bool keepsRecord, MachineProfile? profile) => address switch
    {
        TcpAddress tcp => new MachineConnection(
            $"tcp://{tcp.Host}:{tcp.Port}",
            simulator: null,
            async cancellation => await TcpLink.ConnectAsync(tcp.Host, tcp.Port, s_connectTimeout, time, cancellation).ConfigureAwait(false),
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
    /// <param name="description">Its address for display and for the journal.</param>
    internal static MachineConnection Through(string description, Func<CancellationToken, Task<IControllerLink>> open, Func<MachineClock> takeClock) => new(description, simulator: null, open, takeClock);

    /// <summary>Opens one more link (one more handle of the controller).</summary>
    public Task<IControllerLink> OpenLinkAsync(CancellationToken cancellation) => _open(cancellation);

    /// <summary>Opens a line terminal.</summary>
    /// <exception cref="ControllerException">The link could not be established.</exception>
    public async Task<IMachineTerminal> OpenTerminalAsync(TimeProvider time, CancellationToken cancellation) => await MachineTerminal.OpenAsync(OpenLinkAsync, time, cancellation).ConfigureAwait(false);

    /// <summary>Performs the handshake over separate links with the wall clock or another one: for polling, not for jobs
    /// (<see cref="MachineClock"/>).</summary>
    /// <exception cref="ControllerException">The controller does not answer.</exception>
    public async Task<IMachineConnection> ShakeHandsAsync(TimeProvider time, CancellationToken cancellation) =>
        await GalilConnection.OpenAsync(OpenLinkAsync, trace: null, time, cancellation).ConfigureAwait(false);

    /// <summary>The clock for a job. A simulated controller provides its own clock, one in another process only if its speed is not 1. Its time then advances
    /// only with the job's commands and waits, until the clock is disposed.</summary>
    /// <exception cref="ControllerLinkException">No clock is offered at the address.</exception>
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
