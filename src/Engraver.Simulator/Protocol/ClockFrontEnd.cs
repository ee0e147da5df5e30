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
            Talk(socket, cancellation);
            served.TrySetResult();
        }
        catch (Exception gone) when (gone is IOException or ObjectDisposedException or SocketException)
        {
            served.TrySetResult(); // the host has gone, or the controller is disposed; the clock is given back in either case
        }
        catch (Exception failure)
        {
            served.TrySetException(failure);
        }
    }

    /// <summary>Until the host has gone. The clock is given back at the end.</summary>
    private void Talk(Socket socket, CancellationToken cancellation)
    {
        using var stopping = cancellation.UnsafeRegister(static reading => ((Socket)reading!).Dispose(), socket);
        using var clock = _core.Hosts.Join();
        using var stream = new NetworkStream(socket, ownsSocket: true);
        using var reader = new StreamReader(stream, Encoding.ASCII, false, 128, leaveOpen: true);
        var host = new ClockLine(clock, socket);
        while (reader.ReadLine() is { } line && host.Takes(line)) { }
    }

    /// <summary>One connection. Lines come in its thread; a wait ends in that thread or in the one that lets the time pass.</summary>
    private sealed class ClockLine(HostClock clock, Socket socket)
    {
        /// <summary>The last wait that the host asked for; null before the first.</summary>
        private OpenWait? _wait;

        /// <returns>False when the line is none of the clock's.</returns>
        public bool Takes(string line)
        {
            if (_wait?.TryEnd() == true)
            {
                _wait.Timer?.Dispose();
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
            var wait = new OpenWait();
            _wait = wait;

            // Task.Delay truncates to whole milliseconds: a wait of less would pass no time, and its host would ask for it again and again.
            wait.Timer = clock.CreateTimer(_ => Passed(wait), null, TimeSpan.FromMicroseconds(microseconds), Timeout.InfiniteTimeSpan);
        }

        private void Passed(OpenWait wait)
        {
            try
            {
                if (wait.TryEnd()) Answer();
            }
            catch (Exception gone) when (gone is SocketException or ObjectDisposedException)
            {
                // The connection's own thread sees it too, and ends.
            }
        }

        private void Answer() => socket.Send(Encoding.ASCII.GetBytes(string.Create(CultureInfo.InvariantCulture, $"{clock.GetTimestamp() / TimeSpan.TicksPerMicrosecond}\n")));

        /// <summary>A wait that is ended and answered once: by the time that passed or by the next line. A time that comes late cannot end the wait after it.</summary>
        private sealed class OpenWait
        {
            private int _isOver;

            public ITimer? Timer { get; set; }

            /// <summary>True for the first who asks.</summary>
            public bool TryEnd() => Interlocked.Exchange(ref _isOver, 1) == 0;
        }
    }
}
