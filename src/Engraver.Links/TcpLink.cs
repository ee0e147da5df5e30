using System.Net.Sockets;
using Engraver.Core.Machines;

namespace Engraver.Links;

/// <summary>A link over one TCP connection.</summary>
/// <remarks>Without delay (TCP_NODELAY): one command is one packet, and the next packet carries the acknowledgement.</remarks>
public sealed class TcpLink : IControllerLink
{
    private readonly Socket _socket;

    private TcpLink(Socket socket, string description)
    {
        _socket = socket;
        Description = description;
    }

    public string Description { get; }

    /// <summary>Connects within <paramref name="timeout"/>.</summary>
    /// <param name="resetHint">Sentences for the operator when the other side resets the connection at once, in terms of its controller; null for none.</param>
    /// <exception cref="ControllerLinkException">No listener, an unknown name, or the other side reset the connection.</exception>
    /// <exception cref="ControllerTimeoutException">No reply in time.</exception>
    public static async Task<TcpLink> ConnectAsync(string host, int port, TimeSpan timeout, TimeProvider time, CancellationToken cancellation, Func<string>? resetHint = null)
    {
        var description = $"tcp://{host}:{port}";
        using var limit = new CancellationTokenSource(timeout, time);
        using var either = CancellationTokenSource.CreateLinkedTokenSource(limit.Token, cancellation);
        var socket = new Socket(SocketType.Stream, ProtocolType.Tcp) { NoDelay = true };
        try
        {
            await socket.ConnectAsync(host, port, either.Token).ConfigureAwait(false);
            return new TcpLink(socket, description);
        }
        catch (SocketException failure)
        {
            socket.Dispose();
            var hint = failure.SocketErrorCode == SocketError.ConnectionReset && resetHint is not null ? " " + resetHint() : "";
            throw new ControllerLinkException(Wording.Get("TcpLink.NoConnection", description, SocketReason.Of(failure)) + hint, failure);
        }
        catch (OperationCanceledException failure) when (!cancellation.IsCancellationRequested)
        {
            socket.Dispose();
            throw new ControllerTimeoutException(Wording.Get("TcpLink.NoReply", description, timeout.TotalSeconds), failure);
        }
        catch (OperationCanceledException)
        {
            socket.Dispose();
            throw;
        }
    }

    public async ValueTask WriteAsync(ReadOnlyMemory<byte> bytes, CancellationToken cancellation)
    {
        try
        {
            while (!bytes.IsEmpty) bytes = bytes[await _socket.SendAsync(bytes, SocketFlags.None, cancellation).ConfigureAwait(false)..];
        }
        catch (SocketException failure)
        {
            throw new IOException(SocketReason.Of(failure), failure);
        }
    }

    public async ValueTask<int> ReadAsync(Memory<byte> buffer, CancellationToken cancellation)
    {
        try
        {
            return await _socket.ReceiveAsync(buffer, SocketFlags.None, cancellation).ConfigureAwait(false);
        }
        catch (SocketException failure)
        {
            throw new IOException(SocketReason.Of(failure), failure);
        }
    }

    public ValueTask DisposeAsync()
    {
        _socket.Dispose();
        return ValueTask.CompletedTask;
    }
}
