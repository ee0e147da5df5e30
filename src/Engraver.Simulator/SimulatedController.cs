using System.Net;
using Engraver.Simulator.Clocks;
using Engraver.Simulator.Protocol;

namespace Engraver.Simulator;

/// <summary>A simulated Galil DMC-2143 (galil-dmc.md I): handles over TCP, over UDP and in memory, and a serial port, all connected to one
/// controller.</summary>
/// <remarks>docs/simulator-fidelity.md lists the differences from the real controller.</remarks>
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
        ArgumentOutOfRangeException.ThrowIfLessThan(options.DecodeTime, TimeSpan.Zero);
        ArgumentOutOfRangeException.ThrowIfLessThan(options.HandleCount, 1);
        ArgumentOutOfRangeException.ThrowIfGreaterThan(options.HandleCount, 8);
        _options = options;
        _core = new ControllerCore(options);
    }

    /// <summary>Every sample of motion and every output change so far.</summary>
    public MotionRecord Record => _core.Machine.Record;

    /// <summary>Faults with the exception (an internal error of the simulator) that stopped the controller, on any thread; all links are then cut. Never
    /// completes otherwise.</summary>
    public Task Broken => _core.Broken;

    public ControllerStatus Status => _core.Status;

    /// <summary>Controller time since it was switched on, ticks of 100 ns.</summary>
    public long ClockTicks => _core.Hosts.Now;

    /// <summary>The error (for example a full disk) that stopped writing the record's file; null while writing succeeds.</summary>
    public IOException? RecordFailure => _core.RecordFailure;

    /// <summary>Opens the client end of a new handle, without a socket but with the same bytes. Disposing it frees the handle.</summary>
    /// <exception cref="IOException">All handles are in use.</exception>
    public Stream OpenConnection() => OpenConnection(taken: null);

    /// <summary>Opens the client end of a new handle, with a callback for each write.</summary>
    /// <param name="taken">Called for each write before it is executed, with the current <see cref="ClockTicks"/>; under the controller's lock. Null for no
    /// callback.</param>
    /// <exception cref="IOException">All handles are in use.</exception>
    public Stream OpenConnection(Action<long>? taken)
    {
        const int ConventionalPort = 23;
        var handle = _core.Open(ConventionalPort, 0, null) ?? throw new IOException("All handles of the controller are busy.");
        return new MemoryConnection(_core, handle, taken);
    }

    /// <summary>Listens on loopback until the controller is disposed; can be called for several ports.</summary>
    /// <param name="port">0 selects a free port.</param>
    /// <exception cref="System.Net.Sockets.SocketException">The port is in use or not allowed.</exception>
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

    /// <summary>Gives the controller's clock to a host in this process: from now on time passes only with the commands of hosts and while every host that has
    /// the clock waits, however late a host is. Disposing the clock returns it.</summary>
    public HostClock JoinClock() => _core.Hosts.Join(isElsewhere: false);

    /// <summary>Offers the clock to hosts in other processes, on loopback until the controller is disposed (docs/simulator-fidelity.md, "The clock"); each
    /// connection counts as one host that has the clock, and a host that hangs is considered lost.</summary>
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
    /// <param name="port">0 selects a free port.</param>
    /// <exception cref="System.Net.Sockets.SocketException">The port is in use or not allowed.</exception>
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

    /// <summary>Opens the client end of the serial port, without a terminal but with the same bytes and, at speed max, the same byte times. Disposing it
    /// disconnects the cable.</summary>
    /// <param name="baud">Bits per second; a byte takes ten bits.</param>
    /// <exception cref="IOException">The port already has a client.</exception>
    public Stream OpenSerialConnection(int baud)
    {
        ArgumentOutOfRangeException.ThrowIfNegativeOrZero(baud);
        return new MemoryConnection(_core, _core.OpenSerial(baud, null) ?? throw new IOException("The serial port has a client."));
    }

    /// <summary>Serves the serial port on a pseudo-terminal (Linux) until the controller is disposed. When its links are cut, the host sees a hang-up and a new
    /// terminal is served at the path.</summary>
    /// <param name="path">Path at which a symbolic link to the terminal is created; it is removed at the end. A link that remains from an earlier run is
    /// replaced.</param>
    /// <param name="baud">Bits per second in each direction; a byte takes ten bits.</param>
    /// <exception cref="IOException">The path is in use or cannot be written, the port already has a client, or the system has no free terminal.</exception>
    /// <exception cref="UnauthorizedAccessException">The path cannot be written.</exception>
    /// <exception cref="PlatformNotSupportedException">The operating system is not Linux.</exception>
    public Task ServeSerialAsync(string path, int baud, CancellationToken cancellation) => ServeSerialAsync(path, baud, null, cancellation);

    /// <summary>Serves the serial port on a pseudo-terminal (Linux), with a callback for all bytes on the line.</summary>
    /// <param name="heard">Called with all bytes as they pass and a flag that is true for bytes from the host, on the threads that transfer them. Null for no
    /// callback.</param>
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

    /// <summary>True when bytes on a served serial line take no time, for traffic whose timing is irrelevant. The listener on the line may set it; the new
    /// value already applies to the bytes of the current call.</summary>
    public bool IsSerialInstant
    {
        get => _core.Machine.Serial.IsInstant;
        set => _core.Machine.Serial.IsInstant = value;
    }

    /// <summary>Cuts every link at once, as by a disconnected cable; motion and programs continue.</summary>
    public void DropConnections() => _core.CutAll();

    /// <summary>Advances virtual time, in addition to the time that passes with commands and silence. Only at speed max.</summary>
    public void Advance(TimeSpan controllerTime)
    {
        RequireVirtualTime();
        _core.Advance(controllerTime);
    }

    /// <summary>Advances virtual time sample by sample until the condition holds; returns false when it does not hold within <paramref name="atMost"/> of
    /// controller time.</summary>
    public bool AdvanceUntil(Func<ControllerStatus, bool> condition, TimeSpan atMost)
    {
        RequireVirtualTime();
        return _core.AdvanceUntil(condition, atMost);
    }

    /// <summary>Advances virtual time until nothing moves and no thread runs.</summary>
    /// <param name="atMost">Maximum controller time.</param>
    /// <param name="longestRest">Returns after this much controller time without motion and without a change of an output.</param>
    /// <param name="steps">Returns after this number of computing steps; a span of constant speed is one step.</param>
    /// <returns>The status at the end, and whether the rest lasted <paramref name="longestRest"/> or would last until a command arrives.</returns>
    public (ControllerStatus Status, bool HasRested) AdvanceToRest(TimeSpan atMost, TimeSpan longestRest, int steps)
    {
        RequireVirtualTime();
        return _core.AdvanceToRest((long)atMost.TotalMilliseconds, (long)longestRest.TotalMilliseconds, steps);
    }

    /// <summary>Completes when the condition holds. It is tested after every command and, while a task waits, every few milliseconds.</summary>
    public Task<ControllerStatus> WaitUntilAsync(Func<ControllerStatus, bool> condition, CancellationToken cancellation) =>
        _core.WaitUntilAsync(condition, cancellation);

    /// <summary>Waits until nothing moves and no thread runs.</summary>
    /// <returns>False when a sequence has run out of segments: the controller then keeps this state until its host ends the sequence (galil-dmc.md
    /// B.7).</returns>
    public async Task<bool> WaitUntilIdleAsync(CancellationToken cancellation)
    {
        var status = await _core.WaitUntilAsync(s => s.IsIdle || (s.IsDry && !s.IsMoving && s.RunningThreads == 0), cancellation).ConfigureAwait(false);
        return status.IsIdle;
    }

    /// <summary>Grounds or opens a limit input of axis 0 to 3 (A to D); under CN -1, the default, a grounded input blocks motion (galil-dmc.md C.1).</summary>
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
    /// the steps that are sent to it.</summary>
    public void HoldMotor(int axis, bool held)
    {
        RequireAxis(axis);
        _core.With(m => m.Motion.Axes[axis].Motor.IsHeld = held);
    }

    /// <summary>Physical motor position of axis 0 to 3, in counts from its position at the first power up. DP, homing and power cycles change the reported
    /// position but not this one.</summary>
    public int MotorPlace(int axis) => (int)Math.Round(Axis(axis, static found => found.Motor.Position - found.Shift), MidpointRounding.AwayFromZero);

    /// <summary>Physical position for a position that the controller reports now, including a stepper's lost steps, in counts from the position of axis 0 to 3
    /// at the first power up.</summary>
    public int PlaceOf(int axis, int position) => (int)Math.Round(Axis(axis, found => position - found.Motor.Lost - found.Shift), MidpointRounding.AwayFromZero);

    /// <summary>Adds a fault to those of the plan. Its trigger is counted from power up; a fault whose trigger has already passed occurs at once.</summary>
    /// <exception cref="System.Text.Json.JsonException">The fault is not valid.</exception>
    public void Schedule(ScheduledFault fault)
    {
        ArgumentNullException.ThrowIfNull(fault);
        if (fault.Validate() is { } flaw) throw new ArgumentException($"{flaw.Field}: {flaw.Reason}", nameof(fault));
        _core.With(m => m.Faults.Add(fault));
    }

    /// <summary>Bytes received from hosts so far, over all links: the number that <see cref="ScheduledFault.AtByte"/> refers to.</summary>
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

    /// <summary>Activates or releases the abort input. Its activation stops all motion without a ramp, and also all programs unless CN's fifth field is 1;
    /// <c>_AB</c> is 0 while it is active (galil-dmc.md D).</summary>
    public void SetAbortInput(bool active) => _core.With(m => m.SetAbortInput(active));

    /// <summary>Stops listening, cuts every link and completes the record's file.</summary>
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
