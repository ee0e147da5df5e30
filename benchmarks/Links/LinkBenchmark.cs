using System.Diagnostics;
using System.Globalization;
using Engraver.Core.Machines;
using Engraver.Workbench.Composition;

namespace Engraver.Benchmarks.Links;

/// <summary>Compares the drivers of serial devices on a pseudo-terminal: an exchange, rest, and how a link ends.</summary>
internal static class LinkBenchmark
{
    public const string ExchangeHead = "| Driver | exchange p50 ms | p99 ms | CPU per exchange ms | CPU at rest | context switches at rest, per s |\n|---|---:|---:|---:|---:|---:|";

    public const string EndHead = "| End of the link | Driver | reported as | after ms | closed after ms | device free after ms |\n|---|---|---|---:|---:|---:|";

    private const int WarmUp = 200;

    /// <summary>The compiler has finished with the measured methods after this time.</summary>
    private static readonly TimeSpan s_settling = TimeSpan.FromSeconds(1);

    /// <summary>A line of a poll, and its reply.</summary>
    private const int ExchangeBytes = 16;

    public static IReadOnlyList<SerialDriver> Drivers { get; } = Enum.GetValues<SerialDriver>();

    public static IReadOnlyList<LinkEnd> Ends { get; } =
    [
        new("the other side vanishes while a read waits", LinkEnding.Vanish, Reads: true),
        new("the other side vanishes while a write waits", LinkEnding.Vanish, Writes: true),
        new("the other side does not read", LinkEnding.None, Writes: true),
        new("the other side sends XOFF and no XON", LinkEnding.None, Writes: true) { Flow = SerialFlow.XonXoff },
        new("closed while a read waits", LinkEnding.Close, Reads: true),
        new("closed while a write waits", LinkEnding.Close, Writes: true),
    ];

    /// <summary>One row of the first table.</summary>
    /// <param name="rest">Duration of the rest.</param>
    public static async Task<string> ExchangesAsync(SerialDriver driver, int exchanges, TimeSpan rest, CancellationToken stop)
    {
        using var terminal = new BenchTerminal();
        await using var connection = At(terminal, driver, SerialFlow.RtsCts);
        var link = await connection.OpenLinkAsync(stop).ConfigureAwait(false);
        try
        {
            terminal.Echo();
            await ExchangeAsync(link, WarmUp, stop).ConfigureAwait(false);
            var before = Environment.CpuUsage.TotalTime;
            var times = await ExchangeAsync(link, exchanges, stop).ConfigureAwait(false);
            var each = (Environment.CpuUsage.TotalTime - before) / exchanges;
            await Task.Delay(s_settling, stop).ConfigureAwait(false);
            var (cpu, switches) = (Environment.CpuUsage.TotalTime, ContextSwitches());
            await Task.Delay(rest, stop).ConfigureAwait(false);
            var load = (Environment.CpuUsage.TotalTime - cpu) / rest;
            var switched = ContextSwitches().Sum(thread => thread.Value - switches.GetValueOrDefault(thread.Key)) / rest.TotalSeconds;
            return string.Create(CultureInfo.InvariantCulture, $"| {SerialDrivers.Name(driver)} | {At(times, 0.5):0.00} | {At(times, 0.99):0.00} | {each.TotalMilliseconds:0.00} | {load * 100.0:0.0} % | {switched:0} |");
        }
        finally
        {
            await link.DisposeAsync().ConfigureAwait(false);
        }
    }

    /// <summary>One row of the second table.</summary>
    public static async Task<string> EndAsync(LinkEnd end, SerialDriver driver, CancellationToken stop)
    {
        var row = await end.RunAsync(driver, At, stop).ConfigureAwait(false);
        return string.Create(CultureInfo.InvariantCulture, $"| {end.Name} | {SerialDrivers.Name(driver)} | {row.Report} | {row.Reported.TotalMilliseconds:0.0} | {row.Closed.TotalMilliseconds:0.0} | {(row.Free is { } free ? free.TotalMilliseconds.ToString("0.0", CultureInfo.InvariantCulture) : "")} |");
    }

    private static MachineConnection At(BenchTerminal terminal, SerialDriver driver, SerialFlow flow) =>
        MachineConnection.To(new SerialAddress(terminal.Device, ControllerAddress.DefaultBaud, flow) { Driver = driver }, TimeProvider.System);

    private static async Task<List<double>> ExchangeAsync(IControllerLink link, int exchanges, CancellationToken stop)
    {
        var (sent, received, times) = (new byte[ExchangeBytes], new byte[ExchangeBytes], new List<double>(exchanges));
        for (var i = 0; i < exchanges; i++)
        {
            var start = Stopwatch.GetTimestamp();
            await link.WriteAsync(sent, stop).ConfigureAwait(false);
            for (var read = 0; read < received.Length;) read += await link.ReadAsync(received.AsMemory(read), stop).ConfigureAwait(false);
            times.Add(Stopwatch.GetElapsedTime(start).TotalMilliseconds);
        }

        times.Sort();
        return times;
    }

    private static double At(List<double> times, double part) => times[Math.Min(times.Count - 1, (int)(times.Count * part))];

    /// <summary>Context switches of each thread of this process so far: each is the end of a wait, or another thread that got the processor. A thread that
    /// ends while they are read is left out.</summary>
    private static Dictionary<string, long> ContextSwitches()
    {
        var switches = new Dictionary<string, long>();
        foreach (var thread in Directory.EnumerateDirectories("/proc/self/task"))
        {
            if (ContextSwitches(thread) is { } count) switches.Add(thread, count);
        }

        return switches;
    }

    /// <param name="thread">Folder of a thread.</param>
    /// <returns>Null when the thread has ended.</returns>
    internal static long? ContextSwitches(string thread)
    {
        try
        {
            return File.ReadLines(Path.Combine(thread, "status"))
                .Where(line => line.Contains("_ctxt_switches:", StringComparison.Ordinal))
                .Sum(line => long.Parse(line.AsSpan(line.IndexOf('\t', StringComparison.Ordinal)), NumberStyles.AllowLeadingWhite, CultureInfo.InvariantCulture));
        }
        catch (IOException)
        {
            return null; // the folder ends with its thread
        }
    }
}
