using System.Diagnostics;
using System.Globalization;

namespace Engraver.Benchmarks.Stops;

/// <summary>Detects a stop on its way to the controller: its first command switches the tool off, its last one brakes the axes.</summary>
internal sealed class StopListener : IDisposable
{
    /// <summary>The head of the table for the lines of <see cref="Row"/>.</summary>
    public const string Head = "| The window | presses | p50 ms | p99 ms | worst ms |\n|---|---:|---:|---:|---:|";

    private static readonly TimeSpan s_timeout = TimeSpan.FromSeconds(60);
    private readonly AutoResetEvent _toolOff = new(false);
    private readonly AutoResetEvent _brake = new(false);
    private long _toolOffAt;
    private long _brakeAt;

    public StopListener(WireTap wire) => wire.CommandReceived += OnCommand;

    /// <summary>A line of the table.</summary>
    public static string Row(string what, double[] milliseconds)
    {
        Array.Sort(milliseconds);
        var count = milliseconds.Length;
        return string.Create(CultureInfo.InvariantCulture, $"| {what} | {count} | {milliseconds[count / 2]:0.00} | {milliseconds[count * 99 / 100]:0.00} | {milliseconds[^1]:0.00} |");
    }

    /// <summary>Discards the commands received so far.</summary>
    public void Reset()
    {
        _toolOff.Reset();
        _brake.Reset();
    }

    /// <summary>Waits for a whole stop of a machine at rest.</summary>
    /// <returns>Milliseconds from a time stamp to its first command.</returns>
    /// <exception cref="TimeoutException">The stop did not arrive.</exception>
    public double AwaitStop(long since)
    {
        Await(_toolOff);
        Await(_brake);
        return Stopwatch.GetElapsedTime(since, Volatile.Read(ref _toolOffAt)).TotalMilliseconds;
    }

    /// <summary>Waits for the stop of a job. A job also switches the tool off at its end, so that the braking command counts.</summary>
    /// <returns>Milliseconds from a time stamp to that command.</returns>
    /// <exception cref="TimeoutException">The stop did not arrive.</exception>
    public double AwaitBrake(long since)
    {
        Await(_brake);
        return Stopwatch.GetElapsedTime(since, Volatile.Read(ref _brakeAt)).TotalMilliseconds;
    }

    public void Dispose()
    {
        _toolOff.Dispose();
        _brake.Dispose();
    }

    private static void Await(AutoResetEvent word)
    {
        if (!word.WaitOne(s_timeout)) throw new TimeoutException("The stop never reached the wire.");
    }

    private void OnCommand(string text, long at)
    {
        if (text.StartsWith("CB", StringComparison.Ordinal))
        {
            Volatile.Write(ref _toolOffAt, at);
            _toolOff.Set();
        }

        if (text.Contains("ST A", StringComparison.Ordinal))
        {
            Volatile.Write(ref _brakeAt, at);
            _brake.Set();
        }
    }
}
