using System.Diagnostics;
using System.Globalization;
using Avalonia.Controls;
using Engraver.Benchmarks.Canvas;
using Engraver.App.Sessions;
using Engraver.Workbench.Commands;

namespace Engraver.Benchmarks.Desktop;

/// <summary><c>--benchmark</c>: measures the figures of the desktop in docs/benchmarks.md.</summary>
internal static class DesktopBenchmark
{
    /// <summary>Runs a benchmark that needs no window on a display.</summary>
    /// <returns>The sentence of what failed; null when all went well.</returns>
    public static string? Run(DesktopOptions options, TextWriter output)
    {
        if (options.Benchmark == BenchmarkName.Canvas)
        {
            CanvasBenchmark.Run([10_000, 100_000, 1_000_000], output);
            return null;
        }

        if (options is { Benchmark: BenchmarkName.Open or BenchmarkName.Weight, File: null }) return Engraver.App.Texts.Text.Get("Start.NoDrawing");
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

    /// <summary>Closes the window once its first frame is drawn, and says how long that took.</summary>
    public static void EndAfterFirstFrame(Window window) =>
        window.Opened += (_, _) => window.RequestAnimationFrame(_ => window.RequestAnimationFrame(_ =>
        {
            TellFirstFrame();
            window.Close();
        }));

    /// <summary>Writes the time from the start of the process to its first frame.</summary>
    public static void TellFirstFrame()
    {
        using var self = Process.GetCurrentProcess();
        Console.Out.WriteLine(string.Create(CultureInfo.InvariantCulture, $"first frame {(DateTime.Now - self.StartTime).TotalMilliseconds:0} ms"));
    }
}
