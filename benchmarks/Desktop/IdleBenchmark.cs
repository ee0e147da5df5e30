using System.Diagnostics;
using System.Globalization;
using Avalonia.Controls;
using Avalonia.Threading;

namespace Engraver.Benchmarks.Desktop;

/// <summary>Measures the processor time of a window on a display without input.</summary>
internal static class IdleBenchmark
{
    private static readonly TimeSpan s_settling = TimeSpan.FromSeconds(5);
    private static readonly TimeSpan s_watched = TimeSpan.FromSeconds(30);

    /// <summary>Waits until the window has settled, measures, writes the figure, and closes the window.</summary>
    public static void Watch(Window window, TextWriter output) => DispatcherTimer.RunOnce(() => Begin(window, output), s_settling);

    private static void Begin(Window window, TextWriter output)
    {
        var before = Used();
        var watch = Stopwatch.StartNew();
        DispatcherTimer.RunOnce(
            () =>
            {
                var used = Used() - before;
                output.WriteLine(string.Create(CultureInfo.InvariantCulture, $"idle: {used.TotalMilliseconds:0} ms of processor in {watch.Elapsed.TotalSeconds:0.0} s, {used / watch.Elapsed * 100.0:0.00} % of one core"));
                window.Close();
            },
            s_watched);
    }

    private static TimeSpan Used()
    {
        using var self = Process.GetCurrentProcess();
        return self.TotalProcessorTime;
    }
}
