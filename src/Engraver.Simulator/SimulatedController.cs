using System.Net;
using Engraver.Simulator.Clocks;
using Engraver.Simulator.Protocol;

namespace Engraver.Simulator;

/// <summary>A simulated Galil DMC-2143 (galil-dmc.md I): handles over TCP and in memory and a serial port, one controller behind them.</summary>
/// <remarks>docs/simulator-fidelity.md says where it differs from the real controller.</remarks>
public sealed class SimulatedController : IAsyncDisposable
{
    private readonly ControllerCore _core;
    private readonly SimulatorOptions _options;
    private readonly Lock _gate = new();
    private readonly List<IAsyncDisposable> _frontEnds = [];

    public SimulatedController(SimulatorOptions options)
    {
        ArgumentNullException.ThrowIfNull(options);
        ArgumentOutOfRangeException.ThrowIfNegativeOrZero(options.Speed);
        ArgumentOutOfRangeException.ThrowIfLessThan(options.HandleCount, 1);
        ArgumentOutOfRangeException.ThrowIfGreaterThan(options.HandleCount, 8);
        _options = options;
        _core = new ControllerCore(options);
    }

    /// <summary>Every sample of motion and every output change so far.</summary>
    public MotionRecord Record => _core.Machine.Record;

    /// <summary>Faults with the exception (a bug of the simulator) that ended its work, on whatever thread it happened; all links are cut then. Never completes
    /// otherwise.</summary>
    public Task Broken => _core.Broken;

    public ControllerStatus Status => _core.Status;

    /// <summary>Controller time since it was switched on, ticks of 100 ns.</summary>
    public long ClockTicks => _core.Hosts.Now;

    /// <summary>The error (a full disk) that ended the writing of the record's file; null while it is written.</summary>
    public IOException? RecordFailure => _core.RecordFailure;

    /// <summary>The client end of a new handle, without a socket but with the same bytes. Disposing it frees the handle.</summary>
    /// <exception cref="IOException">All handles are busy.</exception>
    public Stream OpenConnection() => OpenConnection(taken: null);

    /// <summary>The same with somebody who is told when bytes are taken.</summary>
    /// <param name="taken">Called for each write before it is executed, with <see cref="ClockTicks"/> at that moment; under the controller's lock. Null for
    /// nobody.</param>
    /// <exception cref="IOException">All handles are busy.</exception>
    public Stream OpenConnection(Action<long>? taken)
    {
        const int ConventionalPort = 23;
        var handle = _core.Open(ConventionalPort, 0, null) ?? throw new IOException("All handles of the controller are busy.");
        return new MemoryConnection(_core, handle, taken);
    }

    /// <summary>Listens on loopback until the controller is disposed; may be called for several ports.</summary>
    /// <param name="port">0 lets the system pick.</param>
    /// <exception cref="System.Net.Sockets.SocketException">The port is taken or not allowed.</exception>
    public Task<IPEndPoint> ListenTcpAsync(int port, CancellationToken cancellation)
    {
        cancellation.ThrowIfCancellationRequested();
        var frontEnd = new TcpFrontEnd(_core, port);
        lock (_gate)
        {
            _frontEnds.Add(frontEnd);
        }

        return Task.FromResult(frontEnd.EndPoint);
    }

    /// <summary>Gives the controller's clock to a host of this process: from now on time passes only by the commands of hosts and while every host that has the
    /// clock waits, however late one is. Disposing the clock gives it back.</summary>
    public HostClock JoinClock() => _core.Hosts.Join(isElsewhere: false);

    /// <summary>Offers the clock to hosts in other processes, on loopback until the controller is disposed (docs/simulator-fidelity.md, "The clock"); each
    /// connection counts as one host that has the clock, and one that hangs is given up.</summary>
    /// <exception cref="System.Net.Sockets.SocketException">No port is free.</exception>
    public Task<IPEndPoint> ListenClockAsync(CancellationToken cancellation)
    {
        cancellation.ThrowIfCancellationRequested();
        var frontEnd = new ClockFrontEnd(_core);
        lock (_gate)
        {
            _frontEnds.Add(frontEnd);
        }

        return Task.FromResult(frontEnd.EndPoint);
    }

    /// <summary>Answers datagrams on loopback until the controller is disposed: commands, and data records after DR (galil-dmc.md A.1, A.9; hosts expect port
    /// 60007).</summary>
    /// <param name="port">0 lets the system pick.</param>
    /// <exception cref="System.Net.Sockets.SocketException">The port is taken or not allowed.</exception>
    public Task<IPEndPoint> ListenUdpAsync(int port, CancellationToken cancellation)
    {
        cancellation.ThrowIfCancellationRequested();
        var frontEnd = new UdpFrontEnd(_core, port);
        lock (_gate)
        {
            _frontEnds.Add(frontEnd);
        }

        return Task.FromResult(frontEnd.EndPoint);
    }

    /// <summary>The client end of the serial port, without a terminal but with the same bytes and, at speed max, the same byte times. Disposing it unplugs the
    /// cable.</summary>
    /// <param name="baud">Bits per second; a byte takes ten bits.</param>
    /// <exception cref="IOException">The port already has a client.</exception>
    public Stream OpenSerialConnection(int baud)
    {
        ArgumentOutOfRangeException.ThrowIfNegativeOrZero(baud);
        return new MemoryConnection(_core, _core.OpenSerial(baud, null) ?? throw new IOException("The serial port has a client."));
    }

    /// <summary>Serves the serial port on a pseudo-terminal (Linux) until the controller is disposed. When its links are dropped, the host sees a hang-up and a
    /// new terminal is served at the path.</summary>
    /// <param name="path">A symbolic link to the terminal is made here and removed at the end. A link that an earlier run left behind is replaced.</param>
    /// <param name="baud">Bits per second in each direction; a byte takes ten bits.</param>
    /// <exception cref="IOException">The path is taken or cannot be written, the port already has a client, or the system has no free terminal.</exception>
    /// <exception cref="UnauthorizedAccessException">The path may not be written.</exception>
    /// <exception cref="PlatformNotSupportedException">This is not Linux.</exception>
    public Task ServeSerialAsync(string path, int baud, CancellationToken cancellation) => ServeSerialAsync(path, baud, null, cancellation);

    /// <summary>The same with somebody who listens on the line.</summary>
    /// <param name="heard">Told all bytes as they pass, and whether the host sent them; on the threads that carry them. Null for nobody.</param>
    public Task ServeSerialAsync(string path, int baud, Action<ReadOnlyMemory<byte>, bool>? heard, CancellationToken cancellation)
    {
        ArgumentOutOfRangeException.ThrowIfNegativeOrZero(baud);
        cancellation.ThrowIfCancellationRequested();
        var frontEnd = SerialFrontEnd.Open(_core, path, baud, _options, heard);
        lock (_gate)
        {
            _frontEnds.Add(frontEnd);
        }

        return Task.CompletedTask;
    }

    /// <summary>Whether bytes on a served serial line take no time, as long as what they say is of no interest. Whoever listens on the line may set it, and the
    /// bytes that were just heard go as it says.</summary>
    public bool SerialCarriesAtOnce
    {
        get => _core.Machine.Serial.CarriesAtOnce;
        set => _core.Machine.Serial.CarriesAtOnce = value;
    }

    /// <summary>Cuts every link at once, as a pulled cable would; motion and programs go on.</summary>
    public void DropConnections() => _core.CutAll();

    /// <summary>Lets virtual time pass, in addition to what commands and silence let pass. Only at speed max.</summary>
    public void Advance(TimeSpan controllerTime)
    {
        RequireVirtualTime();
        _core.Advance(controllerTime);
    }

    /// <summary>Lets virtual time pass sample by sample until the condition holds; false when it does not within <paramref name="atMost"/> of controller
    /// time.</summary>
    public bool AdvanceUntil(Func<ControllerStatus, bool> condition, TimeSpan atMost)
    {
        RequireVirtualTime();
        return _core.AdvanceUntil(condition, atMost);
    }

    /// <summary>Lets virtual time pass until nothing moves and no thread runs.</summary>
    /// <param name="atMost">Controller time.</param>
    /// <param name="longestRest">Returns after this much controller time without motion and without a change of an output.</param>
    /// <param name="steps">Returns after so many steps of computing; a span of constant speed is one step.</param>
    /// <returns>The status at the end, and whether the rest lasted <paramref name="longestRest"/> or would last until a command comes.</returns>
    public (ControllerStatus Status, bool HasRested) AdvanceToRest(TimeSpan atMost, TimeSpan longestRest, int steps)
    {
        RequireVirtualTime();
        return _core.AdvanceToRest((long)atMost.TotalMilliseconds, (long)longestRest.TotalMilliseconds, steps);
    }

    /// <summary>Completes when the condition holds. It is tested after every command and, while somebody waits, every few milliseconds.</summary>
    public Task<ControllerStatus> WaitUntilAsync(Func<ControllerStatus, bool> condition, CancellationToken cancellation) =>
        _core.WaitUntilAsync(condition, cancellation);

    /// <summary>Waits until nothing moves and no thread runs.</summary>
    /// <returns>False when a sequence has run out of segments: the controller then stays as it is until its host ends the sequence (galil-dmc.md
    /// B.7).</returns>
    public async Task<bool> WaitUntilIdleAsync(CancellationToken cancellation)
    {
        var status = await _core.WaitUntilAsync(s => s.IsIdle || (s.IsDry && !s.IsMoving && s.RunningThreads == 0), cancellation).ConfigureAwait(false);
        return status.IsIdle;
    }

    /// <summary>Grounds or opens a limit input of axis 0 to 3 (A to D); under CN -1, the default, a grounded one forbids motion (galil-dmc.md C.1).</summary>
    public void SetLimitSwitch(int axis, bool forward, bool active)
    {
        RequireAxis(axis);
        _core.With(m => m.Motion.Axes[axis].Inputs.Ground(forward, active));
    }

    /// <summary>Grounds or opens the home input of axis 0 to 3 (A to D).</summary>
    public void SetHomeSwitch(int axis, bool active)
    {
        RequireAxis(axis);
        _core.With(m => m.Motion.Axes[axis].Inputs.HomeGrounded = active);
    }

    /// <summary>Blocks or frees the shaft of axis 0 to 3. While it is blocked the motor does not move: the position error of a servo grows, and a stepper loses
    /// the steps that it is sent.</summary>
    public void HoldMotor(int axis, bool held)
    {
        RequireAxis(axis);
        _core.With(m => m.Motion.Axes[axis].Motor.IsHeld = held);
    }

    /// <summary>Where the motor of axis 0 to 3 really stands, counts from where it stood at the first power up: DP, homing and power cycles change what that is
    /// called and not where it is.</summary>
    public int MotorPlace(int axis) => (int)Math.Round(Axis(axis, static found => found.Motor.Position - found.Shift), MidpointRounding.AwayFromZero);

    /// <summary>Where a position that the controller now calls so really is, a stepper's lost steps included, counts from where axis 0 to 3 stood at the first
    /// power up.</summary>
    public int PlaceOf(int axis, int position) => (int)Math.Round(Axis(axis, found => position - found.Motor.Lost - found.Shift), MidpointRounding.AwayFromZero);

    /// <summary>One more fault beside those of the plan; its moment counts from power up, and one that is past happens at once.</summary>
    /// <exception cref="System.Text.Json.JsonException">The fault makes no sense.</exception>
    public void Schedule(ScheduledFault fault)
    {
        ArgumentNullException.ThrowIfNull(fault);
        if (fault.Flaw() is { } flaw) throw new ArgumentException($"{flaw.Field}: {flaw.Reason}", nameof(fault));
        _core.With(m => m.Faults.Add(fault));
    }

    /// <summary>Bytes of hosts that have arrived so far, over all links: the moment <see cref="ScheduledFault.AtByte"/> counts.</summary>
    public long BytesArrived
    {
        get
        {
            var bytes = 0L;
            _core.With(m => bytes = m.Faults.Bytes);
            return bytes;
        }
    }

    /// <summary>Sets input 1 to 8; an open input is true.</summary>
    public void SetInput(int input, bool level)
    {
        ArgumentOutOfRangeException.ThrowIfLessThan(input, 1);
        ArgumentOutOfRangeException.ThrowIfGreaterThan(input, 8);
        _core.With(m => m.Inputs.Set(input, level));
    }

    /// <summary>Activates or releases the abort input. Its activation stops all motion without a ramp, and programs too unless CN's fifth field is 1;
    /// <c>_AB</c> is 0 while it is active (galil-dmc.md D).</summary>
    public void SetAbortInput(bool active) => _core.With(m => m.SetAbortInput(active));

    /// <summary>Stops listening, cuts every link, completes the record's file.</summary>
    public async ValueTask DisposeAsync()
    {
        IAsyncDisposable[] listening;
        lock (_gate)
        {
            listening = [.. _frontEnds];
            _frontEnds.Clear();
        }

        foreach (var frontEnd in listening) await frontEnd.DisposeAsync().ConfigureAwait(false);

        _core.Dispose();
    }

    private double Axis(int axis, Func<Motion.Axis, double> value)
    {
        RequireAxis(axis);
        var found = 0.0;
        _core.With(m => found = value(m.Motion.Axes[axis]));
        return found;
    }

    private static void RequireAxis(int axis)
    {
        ArgumentOutOfRangeException.ThrowIfNegative(axis);
        ArgumentOutOfRangeException.ThrowIfGreaterThan(axis, 3);
    }

    private void RequireVirtualTime()
    {
        if (!_options.IsVirtual)
            throw new InvalidOperationException("Time of the controller follows the wall clock; only at speed max it can be advanced.");
    }
}
