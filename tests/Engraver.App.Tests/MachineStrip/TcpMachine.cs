using Engraver.Benchmarks.Stops;
using Engraver.Simulator;

namespace Engraver.App.Tests.MachineStrip;

/// <summary>A simulated controller behind TCP, with a tap on the connection.</summary>
internal sealed class TcpMachine : IDisposable
{
    private readonly Operator _here;
    private readonly SimulatedController _controller;
    private readonly WireTap _wire;
    private readonly string _clock;

    public TcpMachine(Operator here, double speed)
    {
        _here = here;
        _controller = new SimulatedController(new SimulatorOptions { Speed = speed });
        var listening = _controller.ListenTcpAsync(0, CancellationToken.None);
        var offering = speed == 1 ? null : _controller.ListenClockAsync(CancellationToken.None);
        here.Until(() => listening.IsCompleted && offering is null or { IsCompleted: true });
        _clock = offering is null ? "" : FormattableString.Invariant($"?clock={offering.Result.Port}");
        _wire = new WireTap(listening.Result);
        _wire.CommandReceived += (text, _) => CommandReceived?.Invoke(text);
    }

    /// <summary>Raised with each command on its way to the controller; on a thread of the pool.</summary>
    public event Action<string>? CommandReceived;

    /// <summary>The recorded motion of the motors.</summary>
    public MotionRecord Record => _controller.Record;

    public string Address => _wire.Address + _clock;

    public void Dispose()
    {
        _here.Enter("CNCDISCONNECT");
        var ending = Task.WhenAll(_wire.DisposeAsync().AsTask(), _controller.DisposeAsync().AsTask());
        _here.Until(() => ending.IsCompleted);
    }
}
