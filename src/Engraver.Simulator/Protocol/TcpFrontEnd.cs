using System.Net;
using System.Net.Sockets;

namespace Engraver.Simulator.Protocol;

/// <summary>Connections over TCP on loopback; each uses one handle; a connection for which no handle is free is answered with RST (galil-dmc.md A.1).</summary>
internal sealed class TcpFrontEnd : IAsyncDisposable
{
    private readonly ControllerCore _core;
    private readonly LoopbackListener _listener;

    /// <param name="port">0 selects a free port.</param>
    public TcpFrontEnd(ControllerCore core, int port)
    {
        _core = core;
        _listener = new LoopbackListener(core, port, Admit);
    }

    public IPEndPoint EndPoint => _listener.EndPoint;

    public ValueTask DisposeAsync() => _listener.DisposeAsync();

    /// <summary>Called on the listener's thread, which can run before the constructor has returned.</summary>
    private Task? Admit(Socket socket, CancellationToken cancellation)
    {
        var remotePort = ((IPEndPoint)socket.RemoteEndPoint!).Port;
        if (_core.Open(((IPEndPoint)socket.LocalEndPoint!).Port, remotePort, () => Reset(socket)) is { } handle) return ServeAsync(socket, handle, cancellation);
        Reset(socket);
        return null;
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
            // The connection is already broken; it only needs to be closed.
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
            // The client has disconnected; the caller frees its handle.
        }
        catch (ObjectDisposedException)
        {
            // The connection was cut from this side.
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
            // The client no longer receives.
        }
        catch (ObjectDisposedException)
        {
            // The connection was cut from this side.
        }
        catch (OperationCanceledException)
        {
            // The controller is switched off.
        }
    }
}
