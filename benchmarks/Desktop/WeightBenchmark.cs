using System.Diagnostics;
using System.Globalization;
using Engraver.App.Sessions;
using Engraver.App.Shell;
using Engraver.SoftwarePlatform.Headless;

namespace Engraver.Benchmarks.Desktop;

/// <summary>Measures the cost of a large drawing in the desktop: processor time and memory of opening and planning, frames while it is moved, memory after
/// closing and opening it again.</summary>
internal sealed class WeightBenchmark(DesktopSession session, ShellWindow window, HeadlessDesktop desktop, TextWriter output)
{
    private const int Frames = 300;
    private const int Openings = 10;
    private const double MegaByte = 1e6;
    private static readonly TimeSpan s_timeout = TimeSpan.FromMinutes(10);
    private readonly ViewMoves _moves = new(session.Desk);

    public void Run(string drawing)
    {
        ReportMemory("empty");
        Open(drawing, tells: true);
        ReportMemory("opened and planned");
        ReportFrames("pan at extents", _moves.Pan);
        ReportFrames("zoom about extents", _moves.Zoom);
        _moves.GoNear();
        AwaitPicture();
        ReportFrames("pan zoomed in", _moves.Pan);
        ReportFrames("zoom zoomed in", _moves.Zoom);
        ReportMemory("moved");
        for (var opening = 1; opening <= Openings; opening++)
        {
            Await(session.Desk.Queue.RunAsync("CLOSE"));
            Await(session.Desk.SettleAsync());
            Open(drawing, tells: false);
            ReportMemory(string.Create(CultureInfo.InvariantCulture, $"closed and opened {opening} times"));
        }

        Await(session.Desk.Queue.RunAsync("CLOSE"));
        Await(session.Desk.SettleAsync());
        ReportMemory("closed");
        output.WriteLine(string.Create(CultureInfo.InvariantCulture, $"in use then: {GC.GetTotalMemory(forceFullCollection: true) / MegaByte:0} MB"));
    }

    private void Open(string drawing, bool tells)
    {
        var (watch, cpu) = (Stopwatch.StartNew(), Environment.CpuUsage.TotalTime);
        var opening = session.Desk.Queue.RunAsync("OPEN", drawing);
        desktop.StepUntil(() => opening.IsCompleted, s_timeout);
        Tell("read");
        desktop.StepUntil(() => window.Canvas is { Scene: not null, HasPictureOfScene: true }, s_timeout);
        Tell("read and first picture");
        var settling = session.Desk.SettleAsync();
        desktop.StepUntil(() => settling.IsCompleted, s_timeout);
        Tell("read, first picture, order, plan");
        AwaitPicture();
        Tell("all with the picture of the job");

        void Tell(string what)
        {
            if (tells) output.WriteLine(string.Create(CultureInfo.InvariantCulture, $"{what}: {watch.Elapsed.TotalSeconds:0.00} s, CPU {(Environment.CpuUsage.TotalTime - cpu).TotalSeconds:0.00} s"));
        }
    }

    private void AwaitPicture() => desktop.StepUntil(() => window.CanvasSource.IsCurrent && window.Canvas.IsUpToDate, s_timeout);

    /// <summary>Draws frames as fast as possible while the view moves before each.</summary>
    private void ReportFrames(string what, Action<int> move)
    {
        var times = new double[Frames];
        for (var frame = 0; frame < Frames; frame++)
        {
            var watch = Stopwatch.StartNew();
            move(frame);
            desktop.Step();
            times[frame] = watch.Elapsed.TotalMilliseconds;
        }

        Array.Sort(times);
        output.WriteLine(string.Create(CultureInfo.InvariantCulture, $"{what}: {1000.0 * Frames / times.Sum():0} frames/s, p50 {times[Frames / 2]:0.0} ms, p99 {times[Frames * 99 / 100]:0.0} ms, worst {times[^1]:0.0} ms"));
        AwaitPicture();
    }

    /// <summary>Resident memory of the process after the desktop has released what it does not use; nothing is collected for the measurement.</summary>
    private void ReportMemory(string when)
    {
        desktop.StepUntil(() => session.Desk.IsMemoryReclaimed, s_timeout);
        output.WriteLine(string.Create(CultureInfo.InvariantCulture, $"{when}: resident {Environment.WorkingSet / MegaByte:0} MB, of it managed {GC.GetGCMemoryInfo().TotalCommittedBytes / MegaByte:0} MB"));
    }

    private void Await(Task work) => desktop.StepUntil(() => work.IsCompleted, s_timeout);
}
