using System.Globalization;
using System.Net;
using System.Net.Sockets;
using System.Text;
using Engraver.Simulator.Clocks;

namespace Engraver.Simulator.Protocol;

/// <summary>The clock over TCP on loopback, for hosts in other processes: each connection counts as a host that has the clock (<see cref="HostClock"/>), and
/// closing it returns the clock.</summary>
/// <remarks>
/// Lines of ASCII, each ended by LF; numbers are whole microseconds of controller time. <c>now</c> is answered with the time. <c>wait N</c> advances time by N
/// microseconds and is then answered with the time; a <c>stop</c> in the meantime ends the wait, which is then answered at once. Any other line closes the
/// connection.
/// </remarks>
internal sealed class ClockFrontEnd : IAsyncDisposable
{
    private readonly ControllerCore _core;
    private readonly LoopbackListener _listener;

    public ClockFrontEnd(ControllerCore core)
    {
        _core = core;
        _listener = new LoopbackListener(core, 0, (socket, cancellation) => Task.Run(() => ServeAsync(socket, cancellation), CancellationToken.None));
    }

    public IPEndPoint EndPoint => _listener.EndPoint;

    public ValueTask DisposeAsync() => _listener.DisposeAsync();

    private async Task ServeAsync(Socket socket, CancellationToken cancellation)
    {
        await using var stream = new NetworkStream(socket, ownsSocket: true);
        using var clock = _core.Hosts.Join(isElsewhere: true);
        using var reader = new StreamReader(stream, Encoding.ASCII, false, 128, leaveOpen: true);
        var next = reader.ReadLineAsync(cancellation).AsTask();
        try
        {
            while (await next.ConfigureAwait(false) is { } line)
            {
                next = reader.ReadLineAsync(cancellation).AsTask();
                if (line.StartsWith("wait ", StringComparison.Ordinal) && long.TryParse(line.AsSpan(5), NumberStyles.None, CultureInfo.InvariantCulture, out var microseconds))
                    next = await WaitAsync(clock, microseconds, next, reader, cancellation).ConfigureAwait(false);
                else if (line == "stop") continue; // the wait that this line should end has already ended
                else if (line != "now") return;
                await stream.WriteAsync(Encoding.ASCII.GetBytes(string.Create(CultureInfo.InvariantCulture, $"{clock.GetTimestamp() / TimeSpan.TicksPerMicrosecond}\n")), cancellation).ConfigureAwait(false);
            }
        }
        catch (Exception gone) when (gone is IOException or ObjectDisposedException or OperationCanceledException)
        {
            // The host has disconnected, or the controller is disposed; the clock is returned in either case.
        }
    }

    /// <summary>Waits until the time has passed or the next line has arrived: stop, or the end of the stream when the host has disconnected.</summary>
    /// <returns>The read of the line after that.</returns>
    private static async Task<Task<string?>> WaitAsync(HostClock clock, long microseconds, Task<string?> next, StreamReader reader, CancellationToken cancellation)
    {
        var passed = new TaskCompletionSource(TaskCreationOptions.RunContinuationsAsynchronously);

        // Task.Delay truncates to whole milliseconds: a shorter wait would advance no time, and its host would request it repeatedly.
        await using (clock.CreateTimer(_ => passed.TrySetResult(), null, TimeSpan.FromMicroseconds(microseconds), Timeout.InfiniteTimeSpan).ConfigureAwait(false))
        {
            if (await Task.WhenAny(passed.Task, next).ConfigureAwait(false) == passed.Task) return next;
        }

        return await next.ConfigureAwait(false) is null ? Task.FromResult<string?>(null) : reader.ReadLineAsync(cancellation).AsTask();
    }
}
