using System.Diagnostics;
using System.Globalization;
using Avalonia.Input;
using Engraver.App.Canvas.Benchmarks;
using Engraver.App.Canvas.Scenes;
using Engraver.App.Shell;
using Engraver.App.Start;
using Engraver.Simulator;
using Engraver.SoftwarePlatform.Headless;

namespace Engraver.App.Benchmarks;

/// <summary>From the press of Pause to its bytes at the other end of a TCP wire: while the window is idle, while it draws a million segments, and while its thread is held up.</summary>
internal sealed class StopBenchmark(DesktopSession session, ShellWindow window, HeadlessDesktop desktop, TextWriter output) : IDisposable
{
    private const int Presses = 200;
    private const int Segments = 1_000_000;
    private static readonly TimeSpan s_patience = TimeSpan.FromSeconds(60);
    private readonly AutoResetEvent _wentOut = new(false);
    private readonly AutoResetEvent _allOut = new(false);
    private long _heardAt;

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

        if (text.StartsWith("ST ", StringComparison.Ordinal)) _allOut.Set(); // and the braking of the axes its last
    }

    private void Measure(string what, Action<Task> meanwhile)
    {
        var times = new double[Presses];
        meanwhile(Task.Factory.StartNew(() => PressAll(times), CancellationToken.None, TaskCreationOptions.LongRunning, TaskScheduler.Default));
        Array.Sort(times);
        output.WriteLine(string.Create(CultureInfo.InvariantCulture, $"| {what} | {Presses} | {times[Presses / 2]:0.00} | {times[Presses * 99 / 100]:0.00} | {times[^1]:0.00} |"));
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
