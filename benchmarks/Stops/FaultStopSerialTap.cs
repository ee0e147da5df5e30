using System.Diagnostics;
using System.Globalization;
using System.Text;
using Engraver.Workbench.Composition;

namespace Engraver.Benchmarks.Stops;

/// <summary>A pseudo-terminal that simulates a serial line of a baud rate: a command is on the wire when its last bit would have left the line, which
/// transmits ten bits for each byte in sequence.</summary>
/// <remarks>Only the measured part is delayed: what precedes the motion (about ten thousand bytes: the handshake, the watchdog program, the segments that
/// fill the buffer) and what follows the press is transmitted immediately.</remarks>
internal sealed class FaultStopSerialTap : FaultStopWire
{
    private readonly Lock _gate = new();
    private readonly StringBuilder _command = new();
    private readonly ServedSimulator _controller;
    private readonly double _ticksPerByte;

    /// <summary>Time stamp at which the line has transmitted all bytes of the host.</summary>
    private double _free;

    private double _underWay;
    private bool _isPressed;

    /// <param name="baud">Bits per second.</param>
    /// <param name="driver">As in an address; null for the default one.</param>
    private FaultStopSerialTap(ServedSimulator controller, string path, int baud, string? driver)
    {
        _controller = controller;
        controller.IsSerialUnpaced = true;
        _ticksPerByte = Stopwatch.Frequency * 10.0 / baud;
        Address = string.Create(CultureInfo.InvariantCulture, $"serial://{path}?baud={baud}{(driver is null ? "" : $"&driver={driver}")}");
    }

    public override string Address { get; }

    public override double UnderWayMilliseconds
    {
        get
        {
            lock (_gate) return _underWay;
        }
    }

    /// <param name="path">Path of the device that is created; must not exist.</param>
    public static async Task<FaultStopWire> OverSerialAsync(ServedSimulator controller, string path, int baud, string? driver, CancellationToken cancellation)
    {
        var tap = new FaultStopSerialTap(controller, path, baud, driver);
        await controller.ServeSerialAsync(path, baud, tap.OnBytes, cancellation).ConfigureAwait(false);
        return tap;
    }

    public override void Press(long at)
    {
        lock (_gate) (_underWay, _isPressed) = (Milliseconds(Math.Max(0.0, _free - at)), true);
    }

    public override void EndMeasurement() => _controller.IsSerialUnpaced = true;

    /// <summary>The line is closed together with its controller.</summary>
    public override ValueTask DisposeAsync() => ValueTask.CompletedTask;

    private void OnBytes(ReadOnlyMemory<byte> bytes, bool fromHost)
    {
        if (!fromHost) return;
        var came = Stopwatch.GetTimestamp();
        List<(string Text, long At)> commands;
        lock (_gate)
        {
            var busy = Math.Max(_free, came);
            commands = Carried(bytes.Span, came);
            if (_isPressed && !commands.Exists(command => IsStop(command.Text))) _underWay += Milliseconds(_free - busy);
            _isPressed = false;
        }

        foreach (var (text, at) in commands) RaiseCommandPassed(text, at);
    }

    /// <summary>The commands that end in these bytes, each with the time stamp at which its end has left the line: a semicolon ends a command as CR does
    /// (galil-dmc.md A.3).</summary>
    private List<(string Text, long At)> Carried(ReadOnlySpan<byte> bytes, long came)
    {
        var commands = new List<(string, long)>();
        _free = Math.Max(_free, came);
        foreach (var one in bytes)
        {
            if (!_controller.IsSerialUnpaced) _free += _ticksPerByte;
            if (one is not ((byte)'\r' or (byte)';'))
            {
                _command.Append((char)one);
                continue;
            }

            commands.Add((_command.ToString(), (long)_free));
            if (StartsMotion(_command)) _controller.IsSerialUnpaced = false;
            _command.Clear();
        }

        return commands;
    }

    private static double Milliseconds(double ticks) => ticks * 1000.0 / Stopwatch.Frequency;

    /// <summary>The command starts the motion along the path (galil-dmc.md B.1).</summary>
    private static bool StartsMotion(StringBuilder command) => command.Equals("BGS");
}
