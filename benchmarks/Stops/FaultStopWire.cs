using Engraver.Workbench.Composition;

namespace Engraver.Benchmarks.Stops;

/// <summary>The link between a host and a simulated controller, on which the passing commands are observed.</summary>
internal abstract class FaultStopWire : IAsyncDisposable
{
    /// <summary>Raised with each command and the time stamp at which it was on the wire, on any thread.</summary>
    public event Action<string, long>? CommandPassed;

    /// <summary>The address at which the host reaches the controller.</summary>
    public abstract string Address { get; }

    /// <summary>Remaining transmission time at <see cref="Press"/> of the bytes that the host had already written, and of the one line that it was just
    /// writing, milliseconds. 0 if a stop does not wait for them.</summary>
    /// <remarks>A line of the poll has 48 bytes, which take 25 ms at 19,200 baud. If the host wrote it to the device half a millisecond after the press, it
    /// could not be withdrawn; a second line after the press would be a fault of the host and does not count.</remarks>
    public virtual double UnderWayMilliseconds => 0.0;

    /// <summary>STOP is pressed at this time stamp.</summary>
    public virtual void Press(long at)
    {
    }

    /// <summary>Commands from here on are not measured.</summary>
    public virtual void EndMeasurement()
    {
    }

    public abstract ValueTask DisposeAsync();

    /// <summary>The command ends the path, in a line with others or before the stop of the axes.</summary>
    public static bool IsStop(string command)
    {
        ArgumentNullException.ThrowIfNull(command);
        return command.Contains("STS", StringComparison.Ordinal);
    }

    protected void RaiseCommandPassed(string command, long at) => CommandPassed?.Invoke(command, at);

    /// <summary>A TCP connection through a relay.</summary>
    public static async Task<FaultStopWire> OverTcpAsync(ServedSimulator controller, CancellationToken cancellation) => new Tcp(new WireTap(await controller.ListenTcpAsync(0, cancellation).ConfigureAwait(false)));

    private sealed class Tcp : FaultStopWire
    {
        private readonly WireTap _tap;

        public Tcp(WireTap tap)
        {
            _tap = tap;
            tap.CommandReceived += RaiseCommandPassed;
        }

        public override string Address => _tap.Address;

        public override ValueTask DisposeAsync() => _tap.DisposeAsync();
    }
}
