using System.Net;
using System.Net.Sockets;
using System.Text.Json;
using Engraver.Core.Machines;
using Engraver.Galil.Language;
using Engraver.Links;
using Engraver.Simulator;

namespace Engraver.Workbench.Composition;

/// <summary>A simulated controller for other programs: over TCP, UDP or a serial line.</summary>
public sealed class ServedSimulator : IAsyncDisposable
{
    private readonly SimulatedController _controller;

    private ServedSimulator(SimulatorOptions options) => (_controller, Speed) = (new SimulatedController(options), options.Speed);

    /// <summary>Controller seconds per wall-clock second.</summary>
    public double Speed { get; }

    /// <summary>Faults with an internal error of the simulator; its clients are then disconnected.</summary>
    public Task Failure => _controller.Broken;

    /// <summary>Why the record is incomplete; null if complete. Final once the simulator is disposed.</summary>
    public IOException? RecordFailure => _controller.RecordFailure;

    /// <exception cref="JsonException">The faults are not a valid faults file.</exception>
    public static ServedSimulator Create(ServedSimulatorSettings settings)
    {
        ArgumentNullException.ThrowIfNull(settings);
        var options = new SimulatorOptions
        {
            Speed = settings.Speed,
            KeepsRecord = false,
            Faults = settings.Faults is { } faults ? FaultPlan.Parse(faults) : null,
            EarlyRamps = settings.EarlyRamps,
            OnePendingExit = settings.OnePendingExit,
            OwnEntrySpeed = settings.OwnEntrySpeed,
            DecodeTime = settings.DecodeTime,
            NumberSpacing = settings.SignColumn ? NumberSpacing.SignColumn : NumberSpacing.Blank,
        };
        if (settings.SerialNumber is { } number) options = options with { SerialNumber = number };
        if (settings.Profile is { } profile) options = options with { AngleQuantumDegrees = profile.AngleQuantumDegrees, Burned = BurnedFrom(profile), Switches = SimulatedSwitches.Switches(profile) };
        return new ServedSimulator(options);
    }

    /// <summary>Writes every motor sample and output change to a file as CSV, and closes it when the simulator is disposed.</summary>
    public void RecordTo(TextWriter csv) => _controller.Record.AttachCsv(csv);

    /// <param name="port">On loopback; 0 lets the system pick.</param>
    /// <exception cref="IOException">The port is taken or may not be used; the message is the reason.</exception>
    public Task<IPEndPoint> ListenTcpAsync(int port, CancellationToken cancellation) => ListenAsync(() => _controller.ListenTcpAsync(port, cancellation));

    /// <param name="port">On loopback; 0 lets the system pick.</param>
    /// <exception cref="IOException">As for <see cref="ListenTcpAsync"/>.</exception>
    public Task<IPEndPoint> ListenUdpAsync(int port, CancellationToken cancellation) => ListenAsync(() => _controller.ListenUdpAsync(port, cancellation));

    /// <summary>Offers the controller's clock to hosts in other processes.</summary>
    public Task<IPEndPoint> ListenClockAsync(CancellationToken cancellation) => _controller.ListenClockAsync(cancellation);

    /// <summary>Serves a pseudo-terminal; the path becomes a symbolic link to it.</summary>
    /// <param name="heard">Receives all bytes on the line and whether the host sent them; on the transferring threads. Null for none.</param>
    public Task ServeSerialAsync(string path, int baud, Action<ReadOnlyMemory<byte>, bool>? heard, CancellationToken cancellation) => _controller.ServeSerialAsync(path, baud, heard, cancellation);

    /// <summary>Whether bytes on the serial line take no time (<see cref="SimulatedController.IsSerialInstant"/>).</summary>
    public bool IsSerialUnpaced
    {
        get => _controller.IsSerialInstant;
        set => _controller.IsSerialInstant = value;
    }

    /// <summary>Adds faults; one whose time has passed occurs at once.</summary>
    /// <param name="faults">As for <see cref="ServedSimulatorSettings.Faults"/>.</param>
    /// <exception cref="JsonException">The text is not a valid faults file.</exception>
    public void Schedule(string faults)
    {
        foreach (var fault in FaultPlan.Parse(faults).Faults) _controller.Schedule(fault);
    }

    public ValueTask DisposeAsync() => _controller.DisposeAsync();

    private static async Task<IPEndPoint> ListenAsync(Func<Task<IPEndPoint>> listen)
    {
        try
        {
            return await listen().ConfigureAwait(false);
        }
        catch (SocketException taken)
        {
            throw new IOException(SocketReason.Of(taken), taken);
        }
    }

    private static BurnedMotion BurnedFrom(MachineProfile profile)
    {
        var speeds = new int?[1 + profile.Axes.All.Max(axis => axis.Letter - 'A')];
        foreach (var axis in profile.Axes.All) speeds[axis.Letter - 'A'] = profile.RapidSpeed(axis);
        return new BurnedMotion(profile.VectorSpeed(), profile.AccelerationCounts, speeds);
    }
}
