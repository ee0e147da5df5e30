using System.Net;
using System.Net.Sockets;
using System.Text;

namespace Engraver.Simulator.Tests;

/// <summary>A host on a real socket.</summary>
internal sealed class TcpClientEnd : IDisposable
{
    private readonly Socket _socket = new(AddressFamily.InterNetwork, SocketType.Stream, ProtocolType.Tcp) { NoDelay = true };

    public int LocalPort => ((IPEndPoint)_socket.LocalEndPoint!).Port;

    public static async Task<TcpClientEnd> ConnectAsync(IPEndPoint controller, CancellationToken cancellation)
    {
        var client = new TcpClientEnd();
        await client._socket.ConnectAsync(controller, cancellation);
        return client;
    }

    /// <summary>Sends a line and reads until it has received one prompt for each command: they may arrive in several parts.</summary>
    public async Task<string> AskAsync(string line, CancellationToken cancellation)
    {
        var commands = 1 + line.Count(c => c == ';');
        await _socket.SendAsync(Encoding.Latin1.GetBytes(line + "\r"), cancellation);
        var reply = new StringBuilder();
        do
        {
            var part = await ReadAsync(cancellation);
            Assert.NotEqual("", part);
            reply.Append(part);
        }
        while (Prompts(reply.ToString()) < commands);
        return reply.ToString();
    }

    /// <summary>Prompts are at the start of a line or after another prompt.</summary>
    private static int Prompts(string reply)
    {
        var count = 0;
        var start = true;
        foreach (var c in reply)
        {
            var prompt = start && (c is ':' or '?');
            count += prompt ? 1 : 0;
            start = prompt || c == '\n';
        }

        return count;
    }

    /// <summary>The next bytes; empty when the controller closed the connection.</summary>
    public async Task<string> ReadAsync(CancellationToken cancellation)
    {
        var buffer = new byte[4096];
        var count = await _socket.ReceiveAsync(buffer, cancellation);
        return Encoding.Latin1.GetString(buffer, 0, count);
    }

    public void Dispose() => _socket.Dispose();
}
