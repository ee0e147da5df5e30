using System.Net;
using System.Net.Sockets;

namespace Engraver.Simulator.Protocol;

/// <summary>Datagrams on loopback; every sender has one handle until IHx=>-1 frees it (galil-dmc.md A.1). A sender for which no handle is free gets no
/// answer.</summary>
internal sealed class UdpFrontEnd : IAsyncDisposable
{
    private const int LargestDatagram = 2048;
    private readonly ControllerCore _core;
    private readonly Socket _socket = new(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp);
    private readonly CancellationTokenSource _stopping = new();
    private readonly Dictionary<IPEndPoint, Handle> _senders = [];
    private readonly Task _receiving;

    public UdpFrontEnd(ControllerCore core, int port)
    {
        _core = core;
        _socket.Bind(new IPEndPoint(IPAddress.Loopback, port));
        EndPoint = (IPEndPoint)_socket.LocalEndPoint!;
        _receiving = core.WatchAsync(ReceiveAsync(_stopping.Token));
    }

    public IPEndPoint EndPoint { get; }

    public async ValueTask DisposeAsync()
    {
        await _stopping.CancelAsync().ConfigureAwait(false);
        await _receiving.ConfigureAwait(false);
        _socket.Dispose();
        _stopping.Dispose();
    }

    private async Task ReceiveAsync(CancellationToken cancellation)
    {
        var buffer = new byte[LargestDatagram];
        var anyone = new IPEndPoint(IPAddress.Any, 0);
        while (!cancellation.IsCancellationRequested)
        {
            try
            {
                var received = await _socket.ReceiveFromAsync(buffer, SocketFlags.None, anyone, cancellation).ConfigureAwait(false);
                if (HandleOf((IPEndPoint)received.RemoteEndPoint) is { } handle) _core.Receive(handle, buffer.AsSpan(0, received.ReceivedBytes));
            }
            catch (OperationCanceledException)
            {
                return;
            }
            catch (SocketException)
            {
                // A datagram was returned because its receiver no longer exists, or a datagram was too long: neither stops the service.
            }
        }
    }

    private Handle? HandleOf(IPEndPoint sender)
    {
        if (_senders.TryGetValue(sender, out var known) && !known.IsClosed) return known;
        var opened = _core.Open(EndPoint.Port, sender.Port, null, bytes => Send(sender, bytes));
        if (opened is not null) _senders[sender] = opened;
        return opened;
    }

    /// <summary>Sends a datagram without waiting; it may be lost.</summary>
    private void Send(IPEndPoint receiver, ReadOnlySpan<byte> bytes)
    {
        try
        {
            _socket.SendTo(bytes, SocketFlags.None, receiver);
        }
        catch (SocketException)
        {
            // The datagram is lost, which is allowed for datagrams.
        }
        catch (ObjectDisposedException)
        {
            // The controller is switched off.
        }
    }
}
