using System.Diagnostics;
using System.Globalization;
using Avalonia.Controls;
using Engraver.App.Canvas.Benchmarks;
using Engraver.App.Platforms;
using Engraver.App.Start;
using Engraver.Workbench.Commands;

namespace Engraver.App.Benchmarks;

/// <summary><c>--benchmark</c>: what docs/benchmarks.md quotes of the desktop.</summary>
internal static class DesktopBenchmark
{
    /// <summary>From the start of the process to its first frame, which is said on standard output; then the window closes.</summary>
    public const string Start = "start";

    private const string Canvas = "canvas";

    /// <summary>Processor that the window on a display uses while nobody touches it; with drawing and script. Then the window closes.</summary>
    public const string Idle = "idle";

    private const string Stop = "stop";

    /// <summary>The same with keys sent to the window on a display, from outside; with a drawing a job is stopped too. Then the window closes.</summary>
    public const string StopOnDisplay = "stop-display";

    /// <summary>All of the window painted anew, at two sizes.</summary>
    public const string Repaint = "repaint";

    /// <summary>From OPEN to the first picture and to everything that follows.</summary>
    public const string Open = "open";

    public static IReadOnlyList<string> Names { get; } = [Start, Canvas, Stop, Repaint, Open, Idle, StopOnDisplay];

    /// <summary>One of those that need no window of the operator's.</summary>
    /// <returns>The sentence of what failed; null when all went well.</returns>
    public static string? Run(DesktopOptions options, TextWriter output)
    {
        if (options.Benchmark == Canvas)
        {
            CanvasBenchmark.Run([10_000, 100_000, 1_000_000], output);
            return null;
        }

        if (options is { Benchmark: Open, File: null }) return Texts.Text.Of("Start.NoDrawing");
        var session = new DesktopSession(new CommandEnvironment { RunJournalFolder = Path.GetTempPath() });
        try
        {
            return DesktopPlatform.Benchmark(session, options, builder => ((App)builder.Instance!).OpenShell(session), output);
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

    /// <summary>The first frame is there.</summary>
    public static void TellFirstFrame()
    {
        using var self = Process.GetCurrentProcess();
        Console.Out.WriteLine(string.Create(CultureInfo.InvariantCulture, $"first frame {(DateTime.Now - self.StartTime).TotalMilliseconds:0} ms"));
    }
}
