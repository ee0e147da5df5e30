using System.Net;
using System.Net.Sockets;

namespace Engraver.Simulator.Protocol;

/// <summary>Connections over TCP on loopback; each is one handle, one too many is answered with RST (galil-dmc.md A.1).</summary>
internal sealed class TcpFrontEnd : IAsyncDisposable
{
    private readonly ControllerCore _core;
    private readonly Socket _listener = new(AddressFamily.InterNetwork, SocketType.Stream, ProtocolType.Tcp);
    private readonly CancellationTokenSource _stopping = new();
    private readonly Lock _gate = new();
    private readonly HashSet<Task> _clients = [];
    private readonly Task _accepting;

    public TcpFrontEnd(ControllerCore core, int port)
    {
        _core = core;
        _listener.Bind(new IPEndPoint(IPAddress.Loopback, port));
        _listener.Listen();
        EndPoint = (IPEndPoint)_listener.LocalEndPoint!;
        _accepting = core.WatchAsync(AcceptAsync(_stopping.Token));
    }

    public IPEndPoint EndPoint { get; }

    public async ValueTask DisposeAsync()
    {
        await _stopping.CancelAsync().ConfigureAwait(false);
        _listener.Dispose();
        await _accepting.ConfigureAwait(false);
        Task[] open;
        lock (_gate)
        {
            open = [.. _clients];
        }

        await Task.WhenAll(open).ConfigureAwait(false);
        _stopping.Dispose();
    }

    private async Task AcceptAsync(CancellationToken cancellation)
    {
        while (!cancellation.IsCancellationRequested)
        {
            try
            {
                var socket = await _listener.AcceptAsync(cancellation).ConfigureAwait(false);
                Admit(socket, cancellation);
            }
            catch (OperationCanceledException)
            {
                return;
            }
            catch (SocketException)
            {
                // A client that left before it was accepted is no reason to stop listening.
            }
        }
    }

    private void Admit(Socket socket, CancellationToken cancellation)
    {
        socket.NoDelay = true;
        var remotePort = ((IPEndPoint)socket.RemoteEndPoint!).Port;
        if (_core.Open(EndPoint.Port, remotePort, () => Reset(socket)) is not { } handle)
        {
            Reset(socket);
            return;
        }

        handle.Between = () => HasArrived(socket);
        var serving = _core.WatchAsync(ServeAsync(socket, handle, cancellation));
        lock (_gate)
        {
            _clients.RemoveWhere(c => c.IsCompleted);
            _clients.Add(serving);
        }
    }

    private static bool HasArrived(Socket socket)
    {
        try
        {
            return socket.Available > 0;
        }
        catch (Exception gone) when (gone is SocketException or ObjectDisposedException)
        {
            return false;
        }
    }

    private static void Reset(Socket socket)
    {
        try
        {
            socket.LingerState = new LingerOption(true, 0);
        }
        catch (ObjectDisposedException)
        {
            return;
        }
        catch (SocketException)
        {
            // Already broken: closing is all that is left.
        }

        socket.Dispose();
    }

    private async Task ServeAsync(Socket socket, Handle handle, CancellationToken cancellation)
    {
        var sending = SendAsync(socket, handle, cancellation);
        await ReceiveAsync(socket, handle, cancellation).ConfigureAwait(false);
        _core.Detach(handle);
        await sending.ConfigureAwait(false);
        socket.Dispose();
    }

    private async Task ReceiveAsync(Socket socket, Handle handle, CancellationToken cancellation)
    {
        var buffer = new byte[4096];
        try
        {
            while (!handle.IsClosed && await socket.ReceiveAsync(buffer, cancellation).ConfigureAwait(false) is > 0 and var length)
            {
                _core.Receive(handle, buffer.AsSpan(0, length));
            }
        }
        catch (SocketException)
        {
            // The client is gone; its handle is freed by the caller.
        }
        catch (ObjectDisposedException)
        {
            // Cut from this side.
        }
        catch (OperationCanceledException)
        {
            // The controller is switched off.
        }
    }

    private static async Task SendAsync(Socket socket, Handle handle, CancellationToken cancellation)
    {
        var buffer = new byte[4096];
        try
        {
            while (await handle.Output.ReadAsync(buffer, cancellation).ConfigureAwait(false) is > 0 and var length)
            {
                for (var sent = 0; sent < length;)
                {
                    sent += await socket.SendAsync(buffer.AsMemory(sent, length - sent), cancellation).ConfigureAwait(false);
                }
            }

            socket.Shutdown(SocketShutdown.Both);
        }
        catch (SocketException)
        {
            // Nobody listens any more.
        }
        catch (ObjectDisposedException)
        {
            // Cut from this side.
        }
        catch (OperationCanceledException)
        {
            // The controller is switched off.
        }
    }
}
