using Engraver.Workbench.Composition;

namespace Engraver.Benchmarks.Stops;

/// <summary>The link between a host and a simulated controller, on which the commands are heard that pass.</summary>
internal abstract class FaultStopWire : IAsyncDisposable
{
    /// <summary>Raised with each command and the time stamp at which it was on the wire, on any thread.</summary>
    public event Action<string, long>? Heard;

    /// <summary>Where the host finds the controller.</summary>
    public abstract string Address { get; }

    /// <summary>How long the wire was still busy at <see cref="Press"/> with bytes that the host had given it, milliseconds. 0 where a stop does not wait for them.</summary>
    public virtual double UnderWayMilliseconds => 0.0;

    /// <summary>STOP is pressed at this time stamp.</summary>
    public virtual void Press(long at)
    {
    }

    /// <summary>What is said from here on is not measured any more.</summary>
    public virtual void Rest()
    {
    }

    public abstract ValueTask DisposeAsync();

    protected void Tell(string command, long at) => Heard?.Invoke(command, at);

    /// <summary>A TCP connection through a relay.</summary>
    public static async Task<FaultStopWire> OverTcpAsync(ServedSimulator controller, CancellationToken cancellation) => new Tcp(new WireTap(await controller.ListenTcpAsync(0, cancellation).ConfigureAwait(false)));

    private sealed class Tcp : FaultStopWire
    {
        private readonly WireTap _tap;

        public Tcp(WireTap tap)
        {
            _tap = tap;
            tap.Heard += Tell;
        }

        public override string Address => _tap.Address;

        public override ValueTask DisposeAsync() => _tap.DisposeAsync();
    }
}
