using System.Diagnostics;
using System.Globalization;
using Avalonia;
using Avalonia.Media;
using Engraver.App.Sessions;
using Engraver.App.Shell;
using Engraver.SoftwarePlatform.Headless;

namespace Engraver.Benchmarks.Desktop;

/// <summary>Measures how long a window in memory takes to repaint completely and to open a drawing.</summary>
internal sealed class WindowBenchmark(DesktopSession session, ShellWindow window, HeadlessDesktop desktop, TextWriter output)
{
    private const int Frames = 200;
    private static readonly TimeSpan s_timeout = TimeSpan.FromMinutes(10);
    private static readonly Size[] s_sizes = [new(1280, 800), new(2560, 1440)];

    /// <summary>Measures frames in which everything is painted, because the background of the window changes.</summary>
    /// <param name="drawing">Path of the drawing that is open; null: none.</param>
    public void Repaint(string? drawing)
    {
        if (drawing is not null) Await(session.Desk.Queue.RunAsync("OPEN", drawing));
        Await(session.Desk.SettleAsync());
        output.WriteLine("| Window | frames | p50 ms | p99 ms | worst ms |");
        output.WriteLine("|---|---:|---:|---:|---:|");
        foreach (var size in s_sizes)
        {
            desktop.Windows[0].Resize(size);
            desktop.StepUntil(() => window.Canvas.IsUpToDate, s_timeout);
            var times = Enumerable.Range(0, Frames).Select(PaintAll).Order().ToArray();
            output.WriteLine(string.Create(CultureInfo.InvariantCulture, $"| {size.Width:0} x {size.Height:0} | {Frames} | {times[Frames / 2]:0.0} | {times[Frames * 99 / 100]:0.0} | {times[^1]:0.0} |"));
        }
    }

    /// <summary>Measures the time from the input OPEN to the first picture of the drawing, and until all derivations are complete.</summary>
    public void Open(string drawing)
    {
        var watch = Stopwatch.StartNew();
        var opening = session.Desk.Queue.RunAsync("OPEN", drawing);
        desktop.StepUntil(() => opening.IsCompleted, s_timeout);
        Report("read", watch);
        desktop.StepUntil(() => window.Canvas is { Scene: not null, HasPictureOfScene: true }, s_timeout);
        Report("first picture", watch);
        var settling = session.Desk.SettleAsync();
        desktop.StepUntil(() => settling.IsCompleted, s_timeout);
        Report("order, plan and program", watch);
        desktop.StepUntil(() => window.CanvasSource.IsCurrent && window.Canvas.IsUpToDate, s_timeout);
        Report("picture with its job", watch);
    }

    private double PaintAll(int frame)
    {
        window.Background = new SolidColorBrush(Color.FromRgb(43, 46, (byte)(51 + (frame % 2))));
        var watch = Stopwatch.StartNew();
        desktop.Step();
        return watch.Elapsed.TotalMilliseconds;
    }

    private void Report(string what, Stopwatch watch) => output.WriteLine(string.Create(CultureInfo.InvariantCulture, $"{what}: {watch.Elapsed.TotalSeconds:0.00} s"));

    private void Await(Task work) => desktop.StepUntil(() => work.IsCompleted, s_timeout);
}
