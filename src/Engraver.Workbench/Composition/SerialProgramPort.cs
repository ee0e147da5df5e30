using Engraver.Core.Machines;
using Engraver.Core.Sending;
using Engraver.Links.Serial;
using Engraver.Workbench.Sending;

namespace Engraver.Workbench.Composition;

/// <summary>A serial port for programs, based on the serial link of this program. The sender handles XON and XOFF; the driver handles RTS and CTS.</summary>
public sealed class SerialProgramPort : IProgramPort
{
    private readonly ISerialLink _link;

    private SerialProgramPort(ISerialLink link) => _link = link;

    /// <summary>Opens the port exclusively.</summary>
    /// <param name="longestHold">Maximum time in which a line with RTS and CTS accepts no character.</param>
    /// <exception cref="ControllerLinkException">The device does not exist, is not a serial port, is in use, or does not support the rate.</exception>
    /// <exception cref="PlatformNotSupportedException">Serial links are not supported on this system.</exception>
    public static SerialProgramPort Open(SendAddress address, TimeSpan longestHold, TimeProvider time)
    {
        ArgumentNullException.ThrowIfNull(address);
        var port = new SerialAddress(address.Device, address.Baud, address.Flow == SerialFlow.RtsCts ? SerialFlow.RtsCts : SerialFlow.None) { Driver = address.Driver };
        return new SerialProgramPort(SerialLink.Open(port, longestHold, time));
    }

    public ValueTask WriteAsync(ReadOnlyMemory<byte> bytes, CancellationToken cancellation) => _link.WriteAsync(bytes, cancellation);

    public ValueTask<int> ReadAsync(Memory<byte> buffer, CancellationToken cancellation) => _link.ReadAsync(buffer, cancellation);

    public async ValueTask DrainAsync(CancellationToken cancellation) => await _link.DrainAsync(cancellation).ConfigureAwait(false);

    public ValueTask DisposeAsync() => _link.DisposeAsync();
}
