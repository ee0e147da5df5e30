using Engraver.Core.Machines;
using Engraver.Core.Sending;
using Engraver.Links.Serial;
using Engraver.Workbench.Sending;

namespace Engraver.Workbench.Composition;

/// <summary>A serial port as a line for programs, over the one serial link of this program. XON and XOFF are left to whoever sends, who counts by them; RTS
/// and CTS are the driver's.</summary>
public sealed class ProgramLine : IProgramLine
{
    private readonly SerialLink _link;

    private ProgramLine(SerialLink link) => _link = link;

    /// <summary>Opens the port for this program alone.</summary>
    /// <param name="longestHold">Time in which a line with RTS and CTS may take no character.</param>
    /// <exception cref="ControllerLinkException">There is no such device, it is no serial line, another program has it, or it does not do the rate.</exception>
    /// <exception cref="PlatformNotSupportedException">Serial links are not built for this computer.</exception>
    public static ProgramLine Open(SendAddress address, TimeSpan longestHold, TimeProvider time)
    {
        ArgumentNullException.ThrowIfNull(address);
        var port = new SerialAddress(address.Device, address.Baud, address.Flow == SerialFlow.RtsCts ? SerialFlow.RtsCts : SerialFlow.None);
        return new ProgramLine(SerialLink.Open(port, longestHold, time));
    }

    public ValueTask WriteAsync(ReadOnlyMemory<byte> bits, CancellationToken cancellation) => _link.WriteAsync(bits, cancellation);

    public ValueTask<int> ReadAsync(Memory<byte> bits, CancellationToken cancellation) => _link.ReadAsync(bits, cancellation);

    public async ValueTask DrainAsync(CancellationToken cancellation) => await _link.DrainAsync(cancellation).ConfigureAwait(false);

    public ValueTask DisposeAsync() => _link.DisposeAsync();
}
