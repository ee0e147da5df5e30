using Engraver.Workbench.Composition;

namespace Engraver.Benchmarks.Stops;

/// <summary>The link between a host and a simulated controller, with the commands that pass over it.</summary>
internal abstract class FaultStopWire : IAsyncDisposable
{
    /// <summary>Raised with each command and the time stamp at which it was on the wire, on any thread.</summary>
    public event Action<string, long>? Heard;

    /// <summary>The address of the controller for the host.</summary>
    public abstract string Address { get; }

    /// <summary>Time for which the wire was still busy at <see cref="Press"/> with bytes from the host, including the line that it was just writing,
    /// milliseconds. 0 if a stop does not wait for them.</summary>
    /// <remarks>A line of the poll has 48 bytes, which take 25 ms at 19,200 baud. If the host gave it to the device half a millisecond after the press, it
    /// could not be withdrawn; a second line after the press would be an error of the host and does not count.</remarks>
    public virtual double UnderWayMilliseconds => 0.0;

    /// <summary>STOP is pressed at this time stamp.</summary>
    public virtual void Press(long at)
    {
    }

    /// <summary>From now on commands are not measured.</summary>
    public virtual void Rest()
    {
    }

    public abstract ValueTask DisposeAsync();

    /// <summary>The command ends the path, in a line with others or before the end of the axes.</summary>
    public static bool IsStop(string command)
    {
        ArgumentNullException.ThrowIfNull(command);
        return command.Contains("STS", StringComparison.Ordinal);
    }

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
