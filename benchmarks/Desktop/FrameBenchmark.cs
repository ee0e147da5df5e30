using System.Diagnostics;
using System.Globalization;
using Avalonia.Threading;
using Engraver.App.Desk;
using Engraver.App.Shell;

namespace Engraver.Benchmarks.Desktop;

/// <summary>Measures the time between frames of a window on a display while its view moves before each: what the operator sees, including the pace of the
/// window system.</summary>
internal sealed class FrameBenchmark(DesktopModel desk, ShellWindow window, TextWriter output)
{
    private const int Frames = 300;
    private readonly ViewMoves _moves = new(desk);

    public async Task RunAsync()
    {
        await desk.SettleAsync();
        await PictureAsync();
        await ReportAsync("pan at extents", _moves.Pan);
        await ReportAsync("zoom about extents", _moves.Zoom);
        _moves.GoNear();
        await PictureAsync();
        await ReportAsync("pan zoomed in", _moves.Pan);
        await ReportAsync("zoom zoomed in", _moves.Zoom);
    }

    /// <summary>Waits for the whole picture of the present view.</summary>
    private async Task PictureAsync()
    {
        // Not by frames: frames without changes would follow each other immediately and starve the picture queued behind them.
        while (!window.CanvasSource.IsCurrent || !window.Canvas.IsUpToDate) await Dispatcher.UIThread.InvokeAsync(() => { }, DispatcherPriority.ApplicationIdle);
    }

    private async Task ReportAsync(string what, Action<int> move)
    {
        var (times, cpu, all) = (new double[Frames], Environment.CpuUsage.TotalTime, new TaskCompletionSource());
        var watch = Stopwatch.StartNew();
        Next(-1);
        await all.Task;
        var used = Environment.CpuUsage.TotalTime - cpu;
        Array.Sort(times);
        await output.WriteLineAsync(string.Create(
            CultureInfo.InvariantCulture,
            $"{what}: {1000.0 * Frames / times.Sum():0.0} frames/s, p50 {times[Frames / 2]:0.0} ms, p99 {times[Frames * 99 / 100]:0.0} ms, worst {times[^1]:0.0} ms, processor {used.TotalMilliseconds / Frames:0.0} ms a frame"));
        await Dispatcher.UIThread.InvokeAsync(PictureAsync);

        void Next(int frame) => window.RequestAnimationFrame(_ =>
        {
            if (frame >= 0) times[frame] = watch.Elapsed.TotalMilliseconds;
            watch.Restart();
            if (frame == Frames - 1)
            {
                all.SetResult();
                return;
            }

            move(frame + 1);
            Next(frame + 1);
        });
    }
}
