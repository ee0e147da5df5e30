using System.Diagnostics;
using System.Net;
using System.Net.Sockets;
using System.Text;

namespace Engraver.Benchmarks.Stops;

/// <summary>A TCP relay that listens on its own port: it passes commands on to the controller and reports each with the time of its arrival.</summary>
internal sealed class WireTap : IAsyncDisposable
{
    private readonly TcpListener _listener = new(IPAddress.Loopback, 0);
    private readonly CancellationTokenSource _ending = new();
    private readonly IPEndPoint _controller;
    private readonly Task _accepting;

    /// <param name="controller">The address of the controller.</param>
    public WireTap(IPEndPoint controller)
    {
        _controller = controller;
        _listener.Start();
        _accepting = AcceptAsync();
    }

    /// <summary>Raised with each command on its way to the controller and its time stamp; on a thread of the pool.</summary>
    public event Action<string, long>? CommandReceived;

    /// <summary>The address at which the controller is reached through the relay.</summary>
    public string Address => FormattableString.Invariant($"tcp://127.0.0.1:{((IPEndPoint)_listener.LocalEndpoint).Port}");

    public async ValueTask DisposeAsync()
    {
        await _ending.CancelAsync().ConfigureAwait(false);
        _listener.Stop();
        await _accepting.ConfigureAwait(ConfigureAwaitOptions.SuppressThrowing);
        _ending.Dispose();
    }

    private async Task AcceptAsync()
    {
        var wires = new List<Task>();
        try
        {
            while (true) wires.Add(CarryAsync(await _listener.AcceptTcpClientAsync(_ending.Token).ConfigureAwait(false)));
        }
        catch (OperationCanceledException)
        {
            await Task.WhenAll(wires).ConfigureAwait(ConfigureAwaitOptions.SuppressThrowing);
        }
    }

    private async Task CarryAsync(TcpClient host)
    {
        using var near = host;
        using var far = new TcpClient { NoDelay = true };
        near.NoDelay = true;
        await far.ConnectAsync(_controller, _ending.Token).ConfigureAwait(false);
        await Task.WhenAny(CopyAsync(near.GetStream(), far.GetStream(), listens: true), CopyAsync(far.GetStream(), near.GetStream(), listens: false)).ConfigureAwait(false);
    }

    private async Task CopyAsync(NetworkStream from, NetworkStream to, bool listens)
    {
        var buffer = new byte[4096];
        while (await from.ReadAsync(buffer, _ending.Token).ConfigureAwait(false) is > 0 and var count)
        {
            var came = Stopwatch.GetTimestamp();
            if (listens) CommandReceived?.Invoke(Encoding.ASCII.GetString(buffer, 0, count), came);
            await to.WriteAsync(buffer.AsMemory(0, count), _ending.Token).ConfigureAwait(false);
        }
    }
}
