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
    private static readonly TimeSpan s_patience = TimeSpan.FromMinutes(10);
    private readonly ViewMoves _moves = new(session.Desk);

    public void Run(string drawing)
    {
        TellMemory("empty");
        Open(drawing, tells: true);
        TellMemory("opened and planned");
        TellFrames("pan at extents", _moves.Pan);
        TellFrames("zoom about extents", _moves.Zoom);
        _moves.GoNear();
        AwaitPicture();
        TellFrames("pan zoomed in", _moves.Pan);
        TellFrames("zoom zoomed in", _moves.Zoom);
        TellMemory("moved");
        for (var opening = 1; opening <= Openings; opening++)
        {
            Await(session.Desk.Queue.RunAsync("CLOSE"));
            Await(session.Desk.SettleAsync());
            Open(drawing, tells: false);
            TellMemory(string.Create(CultureInfo.InvariantCulture, $"closed and opened {opening} times"));
        }

        Await(session.Desk.Queue.RunAsync("CLOSE"));
        Await(session.Desk.SettleAsync());
        TellMemory("closed");
        output.WriteLine(string.Create(CultureInfo.InvariantCulture, $"in use then: {GC.GetTotalMemory(forceFullCollection: true) / MegaByte:0} MB"));
    }

    private void Open(string drawing, bool tells)
    {
        var (watch, cpu) = (Stopwatch.StartNew(), Environment.CpuUsage.TotalTime);
        var opening = session.Desk.Queue.RunAsync("OPEN", drawing);
        desktop.StepUntil(() => opening.IsCompleted, s_patience);
        Tell("read");
        desktop.StepUntil(() => window.Canvas is { Scene: not null, HasPictureOfScene: true }, s_patience);
        Tell("read and first picture");
        var settling = session.Desk.SettleAsync();
        desktop.StepUntil(() => settling.IsCompleted, s_patience);
        Tell("read, first picture, order, plan");
        AwaitPicture();
        Tell("all with the picture of the job");

        void Tell(string what)
        {
            if (tells) output.WriteLine(string.Create(CultureInfo.InvariantCulture, $"{what}: {watch.Elapsed.TotalSeconds:0.00} s, CPU {(Environment.CpuUsage.TotalTime - cpu).TotalSeconds:0.00} s"));
        }
    }

    private void AwaitPicture() => desktop.StepUntil(() => window.CanvasSource.IsCurrent && window.Canvas.IsFresh, s_patience);

    /// <summary>Draws frames as fast as possible while the view moves before each.</summary>
    private void TellFrames(string what, Action<int> move)
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
    private void TellMemory(string when)
    {
        desktop.StepUntil(() => session.Desk.IsMemoryReleased, s_patience);
        output.WriteLine(string.Create(CultureInfo.InvariantCulture, $"{when}: resident {Environment.WorkingSet / MegaByte:0} MB, of it managed {GC.GetGCMemoryInfo().TotalCommittedBytes / MegaByte:0} MB"));
    }

    private void Await(Task work) => desktop.StepUntil(() => work.IsCompleted, s_patience);
}
