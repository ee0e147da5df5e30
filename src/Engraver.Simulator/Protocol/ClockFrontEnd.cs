using System.Globalization;
using System.Net;
using System.Net.Sockets;
using System.Text;
using Engraver.Simulator.Clocks;

namespace Engraver.Simulator.Protocol;

/// <summary>The clock over TCP on loopback, for hosts in other processes: each connection counts as a host that has the clock (<see cref="HostClock"/>), and closing it gives the clock back.</summary>
/// <remarks>
/// Lines of ASCII, each ended by LF; numbers are whole microseconds of controller time. <c>now</c> is answered with the time. <c>wait N</c> lets N microseconds pass and is then answered with the
/// time; a <c>stop</c> meanwhile ends the wait, which is then answered at once. Any other line closes the connection.
/// A host asks at almost every command. Each connection therefore has a thread that reads and answers: waking threads of the pool for each line took more processor time than the controller itself.
/// </remarks>
internal sealed class ClockFrontEnd : IAsyncDisposable
{
    private readonly ControllerCore _core;
    private readonly LoopbackListener _listener;

    public ClockFrontEnd(ControllerCore core)
    {
        _core = core;
        _listener = new LoopbackListener(core, 0, ServeAsync);
    }

    public IPEndPoint EndPoint => _listener.EndPoint;

    public ValueTask DisposeAsync() => _listener.DisposeAsync();

    private Task ServeAsync(Socket socket, CancellationToken cancellation)
    {
        var served = new TaskCompletionSource(TaskCreationOptions.RunContinuationsAsynchronously);
        new Thread(() => Serve(socket, served, cancellation)) { IsBackground = true, Name = "a host's clock" }.Start();
        return served.Task;
    }

    private void Serve(Socket socket, TaskCompletionSource served, CancellationToken cancellation)
    {
        try
        {
            using var stopping = cancellation.UnsafeRegister(static reading => ((Socket)reading!).Dispose(), socket);
            using var clock = _core.Hosts.Join();
            using var stream = new NetworkStream(socket, ownsSocket: true);
            using var reader = new StreamReader(stream, Encoding.ASCII, false, 128, leaveOpen: true);
            var host = new ClockLine(clock, socket);
            while (reader.ReadLine() is { } line && host.Takes(line)) { }
            served.SetResult();
        }
        catch (Exception gone) when (gone is IOException or ObjectDisposedException or SocketException)
        {
            served.SetResult(); // the host has gone, or the controller is disposed; the clock is given back in either case
        }
        catch (Exception failure)
        {
            served.SetException(failure);
        }
    }

    /// <summary>One connection. Lines come in its thread; a wait ends in that thread or in the one that lets the time pass.</summary>
    private sealed class ClockLine(HostClock clock, Socket socket)
    {
        private ITimer? _wait;
        private int _unanswered;

        /// <returns>False when the line is none of the clock's.</returns>
        public bool Takes(string line)
        {
            if (TakeWait())
            {
                _wait!.Dispose();
                Answer();
                return true;
            }

            if (line.StartsWith("wait ", StringComparison.Ordinal) && long.TryParse(line.AsSpan(5), NumberStyles.None, CultureInfo.InvariantCulture, out var microseconds)) Wait(microseconds);
            else if (line == "now") Answer();
            else return line == "stop"; // the wait that it was to end had already ended
            return true;
        }

        private void Wait(long microseconds)
        {
            Volatile.Write(ref _unanswered, 1);

            // Task.Delay truncates to whole milliseconds: a wait of less would pass no time, and its host would ask for it again and again.
            _wait = clock.CreateTimer(_ => Passed(), null, TimeSpan.FromMicroseconds(microseconds), Timeout.InfiniteTimeSpan);
        }

        private void Passed()
        {
            try
            {
                if (TakeWait()) Answer();
            }
            catch (Exception gone) when (gone is SocketException or ObjectDisposedException)
            {
                // The connection's own thread sees it too, and ends.
            }
        }

        /// <summary>True once for each wait: who gets it answers.</summary>
        private bool TakeWait() => Interlocked.Exchange(ref _unanswered, 0) == 1;

        private void Answer() => socket.Send(Encoding.ASCII.GetBytes(string.Create(CultureInfo.InvariantCulture, $"{clock.GetTimestamp() / TimeSpan.TicksPerMicrosecond}\n")));
    }
}
