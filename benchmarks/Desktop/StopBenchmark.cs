using System.Diagnostics;
using Avalonia.Input;
using Engraver.App.Canvas.Scenes;
using Engraver.App.Sessions;
using Engraver.App.Shell;
using Engraver.Benchmarks.Canvas;
using Engraver.Benchmarks.Stops;
using Engraver.Simulator;
using Engraver.SoftwarePlatform.Headless;
using Engraver.Workbench.Machines;

namespace Engraver.Benchmarks.Desktop;

/// <summary>Measures the time from the press of Pause until the bytes of the stop arrive at the other end of a TCP link: while the window is idle, while it
/// draws a million segments, while its thread is blocked, and while a job runs.</summary>
/// <param name="drawing">Path of the drawing whose job is stopped repeatedly; null: stops of a job are not measured.</param>
internal sealed class StopBenchmark(DesktopSession session, ShellWindow window, HeadlessDesktop desktop, string? drawing, TextWriter output)
{
    private static readonly TimeSpan s_timeout = TimeSpan.FromSeconds(60);

    /// <summary>Writes a Markdown table. On the user interface thread.</summary>
    public void Run()
    {
        var controller = new SimulatedController(new SimulatorOptions());
        var wire = new WireTap(controller.ListenTcpAsync(0, CancellationToken.None).GetAwaiter().GetResult());
        using var ear = new StopListener(wire);
        Await(session.Desk.Queue.RunAsync("CNCCONNECT", wire.Address));
        output.WriteLine(StopListener.Head);
        Measure(StopMeasurement.Idle, ear, hand => desktop.StepUntil(() => hand.IsCompleted, TimeSpan.FromHours(1)));
        window.Canvas.Scene = CanvasScene.From(BenchmarkDrawing.Create(StopMeasurement.Segments));
        Measure(StopMeasurement.Redraws, ear, Redraw);
        Measure("its thread is held up", ear, hand => hand.GetAwaiter().GetResult());
        if (drawing is not null) MeasureJobs(drawing, ear);
        Await(session.Desk.Queue.RunAsync("CNCDISCONNECT"));
        Await(wire.DisposeAsync().AsTask());
        Await(controller.DisposeAsync().AsTask());
    }

    /// <summary>Starts jobs and stops each after its streaming has started.</summary>
    private void MeasureJobs(string file, StopListener ear)
    {
        Await(session.Desk.Queue.RunAsync("OPEN", file));
        Await(session.Desk.SettleAsync());
        var times = new double[StopMeasurement.Jobs];
        for (var i = 0; i < times.Length; i++)
        {
            Arm();
            var run = session.Desk.StartArmedAsync();
            desktop.StepUntil(() => session.Desk.Session.Machine is { Status.State: MachineState.Running, Runs.Progress.SegmentsSent: > 0 } || run.IsCompleted, s_timeout);
            if (run.IsCompleted) throw new InvalidOperationException("The job ended before it was stopped.");
            ear.Reset();
            var stopped = StopMeasurement.TimesAsync(1, () => Press(ear.AwaitBrake));
            Await(stopped);
            times[i] = stopped.Result[0];
            Await(run);
        }

        output.WriteLine(StopListener.Row(StopMeasurement.RunsJob, times));
    }

    /// <summary>Arms the job, again if the machine monitor has disarmed it because the machine had only just come to rest.</summary>
    private void Arm()
    {
        while (session.Desk.Session.Machine.Arming.Armed is null)
        {
            desktop.StepUntil(() => session.Desk.Session.Machine.Status.State is MachineState.Ready, s_timeout);
            Await(session.Desk.Queue.RunAsync("CNCARM", "Stream"));
        }
    }

    private void Measure(string what, StopListener ear, Action<Task> meanwhile)
    {
        var hand = StopMeasurement.TimesAsync(StopMeasurement.AtRest, () => Press(ear.AwaitStop));
        meanwhile(hand);
        output.WriteLine(StopListener.Row(what, hand.GetAwaiter().GetResult()));
    }

    private double Press(Func<long, double> heard)
    {
        var pressed = Stopwatch.GetTimestamp();
        desktop.Windows[0].Press(Key.Pause);
        return heard(pressed);
    }

    private void Redraw(Task hand)
    {
        while (!hand.IsCompleted)
        {
            window.Canvas.ForceRefine();
            desktop.Step();
        }
    }

    private void Await(Task work)
    {
        desktop.StepUntil(() => work.IsCompleted, s_timeout);
        work.GetAwaiter().GetResult();
    }
}
