using System.Diagnostics;
using System.Globalization;
using Avalonia.Controls;
using Engraver.App.Sessions;
using Engraver.App.Shell;
using Engraver.Benchmarks.Canvas;
using Engraver.Workbench.Commands;

namespace Engraver.Benchmarks.Desktop;

/// <summary><c>--benchmark</c>: measures the desktop's figures of docs/benchmarks.md.</summary>
internal static class DesktopBenchmark
{
    /// <summary>Runs a benchmark that needs no window on a display.</summary>
    /// <returns>The sentence of the failure; null on success.</returns>
    public static string? Run(DesktopOptions options, TextWriter output)
    {
        if (options.Benchmark == BenchmarkName.Canvas)
        {
            CanvasBenchmark.Run([10_000, 100_000, 1_000_000], output);
            return null;
        }

        if (options is { Benchmark: BenchmarkName.Open or BenchmarkName.Weight or BenchmarkName.Plots, File: null }) return Engraver.App.Texts.Text.Get("Start.NoDrawing");
        var session = new DesktopSession(new CommandEnvironment { RunJournalFolder = Path.GetTempPath() });
        try
        {
            return MemoryBenchmark.Run(session, options, builder => ((Engraver.App.App)builder.Instance!).OpenShell(session), output);
        }
        finally
        {
            session.DisposeAsync().AsTask().GetAwaiter().GetResult();
        }
    }

    /// <summary>Runs a benchmark that needs a window on a display with its drawing open and shown; other names do nothing.</summary>
    public static async Task MeasureAsync(string? benchmark, DesktopSession session, ShellWindow window, string? drawing, TextWriter output)
    {
        switch (benchmark)
        {
            case BenchmarkName.StopOnDisplay:
                await new DisplayStopBenchmark(session.Desk, window, output).RunAsync(drawing);
                window.Close();
                break;
            case BenchmarkName.Frames:
                await new FrameBenchmark(session.Desk, window, output).RunAsync();
                window.Close();
                break;
            case BenchmarkName.Idle:
                IdleBenchmark.Watch(window, output);
                break;
            default:
                break;
        }
    }

    /// <summary>Closes the window after its first frame, and reports the time until then.</summary>
    public static void EndAfterFirstFrame(Window window) =>
        window.Opened += (_, _) => window.RequestAnimationFrame(_ => window.RequestAnimationFrame(_ =>
        {
            ReportFirstFrame();
            window.Close();
        }));

    /// <summary>Writes the time from the start of the process to its first frame.</summary>
    public static void ReportFirstFrame()
    {
        using var self = Process.GetCurrentProcess();
        Console.Out.WriteLine(string.Create(CultureInfo.InvariantCulture, $"first frame {(DateTime.Now - self.StartTime).TotalMilliseconds:0} ms"));
    }
}
