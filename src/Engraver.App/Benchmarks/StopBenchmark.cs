using System.Diagnostics;
using System.Globalization;
using Avalonia.Input;
using Engraver.App.Canvas.Benchmarks;
using Engraver.App.Canvas.Scenes;
using Engraver.App.Shell;
using Engraver.App.Start;
using Engraver.Simulator;
using Engraver.SoftwarePlatform.Headless;
using Engraver.Workbench.Machines;

namespace Engraver.App.Benchmarks;

/// <summary>From the press of Pause to its bytes at the other end of a TCP wire: while the window is idle, while it draws a million segments, and while its thread is held up.</summary>
/// <param name="drawing">The job that is stopped again and again; null: that is not measured.</param>
internal sealed class StopBenchmark(DesktopSession session, ShellWindow window, HeadlessDesktop desktop, string? drawing, TextWriter output) : IDisposable
{
    private const int Presses = 200;
    private const int Jobs = 40;
    private const int Segments = 1_000_000;
    private static readonly TimeSpan s_patience = TimeSpan.FromSeconds(60);
    private readonly AutoResetEvent _wentOut = new(false);
    private readonly AutoResetEvent _allOut = new(false);
    private long _heardAt;
    private long _brakedAt;

    /// <summary>Writes a Markdown table. On the user interface thread.</summary>
    public void Run()
    {
        var controller = new SimulatedController(new SimulatorOptions());
        var wire = new WireTap(controller.ListenTcpAsync(0, CancellationToken.None).GetAwaiter().GetResult());
        wire.Heard += Hear;
        Await(session.Desk.RunAsync("CNCCONNECT", wire.Address));
        output.WriteLine("| The window | presses | p50 ms | p99 ms | worst ms |");
        output.WriteLine("|---|---:|---:|---:|---:|");
        Measure("idle", hand => desktop.StepUntil(() => hand.IsCompleted, TimeSpan.FromHours(1)));
        window.Canvas.Scene = CanvasScene.Of(BenchmarkDrawing.Of(Segments));
        Measure("draws 1,000,000 segments again and again", Redraw);
        Measure("its thread is held up", hand => hand.GetAwaiter().GetResult());
        if (drawing is not null) MeasureJobs(drawing);
        Await(session.Desk.RunAsync("CNCDISCONNECT"));
        Await(wire.DisposeAsync().AsTask());
        Await(controller.DisposeAsync().AsTask());
    }

    public void Dispose()
    {
        _wentOut.Dispose();
        _allOut.Dispose();
    }

    private void Hear(string text, long at)
    {
        if (text.StartsWith("CB", StringComparison.Ordinal)) // tool off is the first word of a stop
        {
            Volatile.Write(ref _heardAt, at);
            _wentOut.Set();
        }

        if (text.Contains("ST A", StringComparison.Ordinal)) // and the braking of the axes its last
        {
            Volatile.Write(ref _brakedAt, at);
            _allOut.Set();
        }
    }

    /// <summary>A job is started and stopped while it streams. Here the word that counts is the braking: a job switches the tool off by itself too.</summary>
    private void MeasureJobs(string file)
    {
        Await(session.Desk.RunAsync("OPEN", file));
        Await(session.Desk.SettleAsync());
        var times = new double[Jobs];
        for (var i = 0; i < Jobs; i++)
        {
            Await(session.Desk.RunAsync("CNCARM", "Stream"));
            var run = session.Desk.StartArmedAsync();
            desktop.StepUntil(() => session.Desk.Session.Machine.Status is { State: MachineState.Running, Progress.SegmentsDone: > 0 } || run.IsCompleted, s_patience);
            while (_allOut.WaitOne(TimeSpan.Zero))
            {
                // what the starting of the job has said
            }

            var at = i;
            Await(Task.Factory.StartNew(() => times[at] = StopJob(), CancellationToken.None, TaskCreationOptions.LongRunning, TaskScheduler.Default));
            Await(run);
        }

        Tell("runs a job", times);
    }

    private double StopJob()
    {
        var pressed = Stopwatch.GetTimestamp();
        desktop.Windows[0].Press(Key.Pause);
        if (!_allOut.WaitOne(s_patience)) throw new TimeoutException("The stop never reached the wire.");
        return Stopwatch.GetElapsedTime(pressed, Volatile.Read(ref _brakedAt)).TotalMilliseconds;
    }

    private void Measure(string what, Action<Task> meanwhile)
    {
        var times = new double[Presses];
        meanwhile(Task.Factory.StartNew(() => PressAll(times), CancellationToken.None, TaskCreationOptions.LongRunning, TaskScheduler.Default));
        Tell(what, times);
    }

    private void Tell(string what, double[] times)
    {
        Array.Sort(times);
        output.WriteLine(string.Create(CultureInfo.InvariantCulture, $"| {what} | {times.Length} | {times[times.Length / 2]:0.00} | {times[times.Length * 99 / 100]:0.00} | {times[^1]:0.00} |"));
    }

    private void PressAll(double[] times)
    {
        var hands = desktop.Windows[0];
        for (var i = 0; i < times.Length; i++)
        {
            var pressed = Stopwatch.GetTimestamp();
            hands.Press(Key.Pause);
            if (!_wentOut.WaitOne(s_patience) || !_allOut.WaitOne(s_patience)) throw new TimeoutException("The stop never reached the wire.");
            times[i] = Stopwatch.GetElapsedTime(pressed, Volatile.Read(ref _heardAt)).TotalMilliseconds;
        }
    }

    private void Redraw(Task hand)
    {
        while (!hand.IsCompleted)
        {
            window.Canvas.RefineAgain();
            desktop.Step();
        }
    }

    private void Await(Task work) => desktop.StepUntil(() => work.IsCompleted, s_patience);
}
