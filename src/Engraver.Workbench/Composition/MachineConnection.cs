using Engraver.Core.Machines;
using Engraver.Core.Motion;
using Engraver.Links;
using Engraver.Links.Serial;
using Engraver.Simulator;

namespace Engraver.Workbench.Composition;

/// <summary>How links to one machine are opened, and the driver that uses them: over the network, over a serial line, or to a simulated controller that runs
/// in this process and is owned here.</summary>
public sealed class MachineConnection : IAsyncDisposable
{
    /// <summary>Serial number of every simulated controller in this process. It is always the same, so that the records of equal runs are equal.</summary>
    internal const int SimulatedSerialNumber = 2143;

    private static readonly TimeSpan s_connectTimeout = TimeSpan.FromSeconds(5);
    private static readonly TimeSpan s_writeTimeout = TimeSpan.FromSeconds(2);
    private readonly Func<CancellationToken, Task<IControllerLink>> _open;
    private readonly Func<MachineClock> _createClock;

    private MachineConnection(IMachineDriver driver, string description, SimulatedController? simulator, Func<CancellationToken, Task<IControllerLink>> open, Func<MachineClock> takeClock)
    {
        Driver = driver;
        Description = description;
        Simulator = simulator;
        _open = open;
        _createClock = takeClock;
    }

    public IMachineDriver Driver { get; }

    public string Description { get; }

    /// <summary>The simulated controller of a <c>sim:</c> address; null for a real link.</summary>
    public SimulatedController? Simulator { get; }

    /// <summary>A machine of the program's own families, at an address without a machine profile: the first family that accepts it.</summary>
    /// <exception cref="PlatformNotSupportedException">Serial links are not supported on this system; thrown when the link is opened.</exception>
    /// <param name="keepsRecord">Whether a simulated controller stores its record; listeners receive the motion in any case.</param>
    public static MachineConnection To(ControllerAddress address, TimeProvider time, bool keepsRecord = false) => MachineFamilies.Standard.At(address, profile: null).Connect(address, time, keepsRecord, null);

    /// <param name="resetHint">As for <see cref="TcpLink.ConnectAsync"/>.</param>
    public static MachineConnection OverNetwork(IMachineDriver driver, TcpAddress address, TimeProvider time, Func<string>? resetHint)
    {
        ArgumentNullException.ThrowIfNull(address);
        return new MachineConnection(
            driver,
            $"tcp://{address.Host}:{address.Port}",
            simulator: null,
            async cancellation => await TcpLink.ConnectAsync(address.Host, address.Port, s_connectTimeout, time, cancellation, resetHint).ConfigureAwait(false),
            () => ClockFor(address, time));
    }

    public static MachineConnection OverSerialLine(IMachineDriver driver, SerialAddress address, TimeProvider time)
    {
        ArgumentNullException.ThrowIfNull(address);
        return new MachineConnection(
            driver,
            $"serial://{address.Device}",
            simulator: null,
            _ => Task.FromResult<IControllerLink>(SerialLink.Open(address, s_writeTimeout, time)),
            () => ClockFor(address, time));
    }

    /// <summary>A simulated DMC-2143 of its own.</summary>
    /// <param name="keepsRecord">As for <see cref="To"/>.</param>
    /// <param name="profile">Where the switches of the simulated machine are; null: it has none.</param>
    public static MachineConnection Simulated(IMachineDriver driver, SimulatedAddress address, TimeProvider time, bool keepsRecord, MachineProfile? profile)
    {
        ArgumentNullException.ThrowIfNull(address);
        var controller = new SimulatedController(new SimulatorOptions { Speed = address.Speed, Time = time, KeepsRecord = keepsRecord, SerialNumber = SimulatedSerialNumber, Switches = profile is null ? [] : SimulatedSwitches.Switches(profile) });
        return new MachineConnection(driver, address.Typed, controller, _ => Task.FromResult<IControllerLink>(LinkTo(controller)), () => MachineClock.FromSimulator(controller.JoinClock()));
    }

    /// <summary>A machine whose links are opened by a function of the caller.</summary>
    /// <param name="description">Its address for display and for the journal.</param>
    /// <param name="driver">Null for the default one.</param>
    public static MachineConnection FromLink(string description, Func<CancellationToken, Task<IControllerLink>> open, Func<MachineClock> takeClock, IMachineDriver? driver = null) =>
        new(driver ?? MachineFamilies.Default, description, simulator: null, open, takeClock);

    /// <summary>Opens one more link (one more handle of the controller).</summary>
    public Task<IControllerLink> OpenLinkAsync(CancellationToken cancellation) => _open(cancellation);

    /// <summary>Opens a line terminal.</summary>
    /// <exception cref="ControllerException">The link could not be opened.</exception>
    public Task<IMachineTerminal> OpenTerminalAsync(TimeProvider time, CancellationToken cancellation) => Driver.OpenTerminalAsync(OpenLinkAsync, time, cancellation);

    /// <summary>Identifies the controller over links of its own, by the wall clock or another: for callers that observe and do not run a job
    /// (<see cref="MachineClock"/>).</summary>
    /// <exception cref="ControllerException">No reply.</exception>
    public Task<IMachineConnection> HandshakeAsync(TimeProvider time, CancellationToken cancellation) => Driver.OpenAsync(OpenLinkAsync, trace: null, time, cancellation);

    /// <summary>The clock for a job. A simulated controller gives its own, one of another process if it is not at speed 1: its time then passes only by the
    /// commands of the job and while the job waits, until the clock is disposed.</summary>
    /// <exception cref="ControllerLinkException">No clock is offered at the port of the address.</exception>
    public MachineClock CreateClock() => _createClock();

    public ValueTask DisposeAsync() => Simulator?.DisposeAsync() ?? ValueTask.CompletedTask;

    private static StreamLink LinkTo(SimulatedController controller)
    {
        var taken = 0L;
        return new StreamLink(controller.OpenConnection(ticks => Volatile.Write(ref taken, ticks)), "sim:") { Received = () => Volatile.Read(ref taken), Now = () => controller.ClockTicks };
    }

    private static MachineClock ClockFor(ControllerAddress address, TimeProvider wall) => address.ClockPort is { } port ? MachineClock.FromOffer(SharedClock.Acquire(port)) : MachineClock.FromWall(wall);
}
