using System.Net;
using System.Net.Sockets;
using System.Text;

namespace Engraver.Cli.Tests.Runs;

/// <summary>A proxy in front of a controller that forwards every byte and changes one line.</summary>
internal sealed class CorruptingProxy : IAsyncDisposable
{
    private readonly TcpListener _listener = new(IPAddress.Loopback, 0);
    private readonly CancellationTokenSource _end = new();
    private readonly int _controllerPort;
    private readonly Func<string, string> _harm;
    private readonly Task _serving;

    /// <param name="harm">Returns the replacement of a line without its CR.</param>
    public CorruptingProxy(int controllerPort, Func<string, string> harm)
    {
        (_controllerPort, _harm) = (controllerPort, harm);
        _listener.Start();
        _serving = ServeAsync();
    }

    public string Address => string.Create(System.Globalization.CultureInfo.InvariantCulture, $"tcp://127.0.0.1:{((IPEndPoint)_listener.LocalEndpoint).Port}");

    public async ValueTask DisposeAsync()
    {
        await _end.CancelAsync();
        _listener.Stop();
        await _serving;
        _end.Dispose();
    }

    private async Task ServeAsync()
    {
        var wires = new List<Task>();
        try
        {
            while (true) wires.Add(CarryAsync(await _listener.AcceptTcpClientAsync(_end.Token)));
        }
        catch (Exception ended) when (ended is OperationCanceledException or SocketException)
        {
            await Task.WhenAll(wires);
        }
    }

    private async Task CarryAsync(TcpClient host)
    {
        using var owned = host;
        using var controller = new TcpClient { NoDelay = true };
        host.NoDelay = true;
        await controller.ConnectAsync(IPAddress.Loopback, _controllerPort, _end.Token);
        var both = new[] { PassAsync(host, controller, _harm), PassAsync(controller, host, null) };
        await Task.WhenAny(both);
        host.Close();
        controller.Close();
        await Task.WhenAll(both);
    }

    private async Task PassAsync(TcpClient from, TcpClient to, Func<string, string>? harm)
    {
        var buffer = new byte[65536];
        var line = new StringBuilder();
        try
        {
            var (source, target) = (from.GetStream(), to.GetStream());
            while (await source.ReadAsync(buffer, _end.Token) is > 0 and var count) await target.WriteAsync(harm is null ? buffer.AsMemory(0, count) : Corrupted(buffer.AsSpan(0, count), line, harm), _end.Token);
        }
        catch (Exception ended) when (ended is OperationCanceledException or IOException or ObjectDisposedException or InvalidOperationException)
        {
            // One side has closed; close the other.
        }
    }

    /// <summary>Forwards complete lines; a download ends with a backslash instead of a CR.</summary>
    private static byte[] Corrupted(ReadOnlySpan<byte> bytes, StringBuilder line, Func<string, string> harm)
    {
        var passed = new StringBuilder();
        foreach (var value in bytes)
        {
            if ((char)value is not ('\r' or '\\'))
            {
                line.Append((char)value);
                continue;
            }

            passed.Append(harm(line.ToString())).Append((char)value);
            line.Clear();
        }

        return Encoding.Latin1.GetBytes(passed.ToString());
    }
}
