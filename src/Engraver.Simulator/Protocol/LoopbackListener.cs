using System.Net;
using System.Net.Sockets;

namespace Engraver.Simulator.Protocol;

/// <summary>Accepts connections on loopback until it is disposed, and then waits for the end of the connections being served. An exception while serving stops
/// the controller.</summary>
internal sealed class LoopbackListener : IAsyncDisposable
{
    private readonly Socket _listener = new(AddressFamily.InterNetwork, SocketType.Stream, ProtocolType.Tcp);
    private readonly CancellationTokenSource _stopping = new();
    private readonly ControllerCore _core;
    private readonly Func<Socket, CancellationToken, Task?> _serve;
    private readonly Lock _gate = new();
    private readonly HashSet<Task> _clients = [];
    private readonly Task _accepting;

    /// <param name="port">0 selects a free port.</param>
    /// <param name="serve">Owns the socket; returns the task that serves it until the client has disconnected, or null when the client was rejected.</param>
    /// <exception cref="SocketException">The port is taken or not allowed.</exception>
    public LoopbackListener(ControllerCore core, int port, Func<Socket, CancellationToken, Task?> serve)
    {
        (_core, _serve) = (core, serve);
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
                socket.NoDelay = true;
                if (_serve(socket, cancellation) is { } serving) Keep(_core.WatchAsync(serving));
            }
            catch (OperationCanceledException)
            {
                return;
            }
            catch (SocketException)
            {
                // A client that disconnects before it is accepted does not stop the listener.
            }
        }
    }

    private void Keep(Task serving)
    {
        lock (_gate)
        {
            _clients.RemoveWhere(client => client.IsCompleted);
            _clients.Add(serving);
        }
    }
}
