using System.Diagnostics;
using Avalonia.Threading;
using Engraver.App.Canvas.Scenes;
using Engraver.App.Desk;
using Engraver.App.Shell;
using Engraver.Benchmarks.Canvas;
using Engraver.Benchmarks.Stops;
using Engraver.Simulator;
using Engraver.Workbench.Machines;

namespace Engraver.Benchmarks.Desktop;

/// <summary>Measures the time from sending a Pause key to an X server, over a second connection, until the bytes of the stop arrive at the other end of a
/// TCP link. The window must be in front.</summary>
internal sealed class DisplayStopBenchmark(DesktopModel desk, ShellWindow window, TextWriter output)
{
    private const nuint PauseKey = 0xFF13;

    /// <summary>Writes a Markdown table. On the user interface thread.</summary>
    /// <param name="drawing">Path of the drawing whose job is stopped repeatedly; null: stops of a job are not measured.</param>
    public async Task RunAsync(string? drawing)
    {
        await using var controller = new SimulatedController(new SimulatorOptions());
        await using var wire = new WireTap(await controller.ListenTcpAsync(0, CancellationToken.None));
        using var ear = new StopListener(wire);
        using var keyboard = new XTestKeyboard();
        await desk.Queue.RunAsync("CNCCONNECT", wire.Address);
        await output.WriteLineAsync(StopListener.Head);
        await MeasureAsync(StopMeasurement.Idle, ear, keyboard);
        window.Canvas.Scene = CanvasScene.From(BenchmarkDrawing.Create(StopMeasurement.Segments));
        var redraw = new DispatcherTimer(TimeSpan.FromMilliseconds(1), DispatcherPriority.Render, (_, _) => window.Canvas.ForceRefine());
        redraw.Start();
        await MeasureAsync(StopMeasurement.Redraws, ear, keyboard);
        redraw.Stop();
        if (drawing is not null) await MeasureJobsAsync(drawing, ear, keyboard);
        await desk.Queue.RunAsync("CNCDISCONNECT");
    }

    private async Task MeasureAsync(string what, StopListener ear, XTestKeyboard keyboard)
    {
        var times = await StopMeasurement.TimesAsync(StopMeasurement.AtRest, () => Press(keyboard, ear.AwaitStop));
        await output.WriteLineAsync(StopListener.Row(what, times));
    }

    private async Task MeasureJobsAsync(string file, StopListener ear, XTestKeyboard keyboard)
    {
        await desk.Queue.RunAsync("OPEN", file);
        await desk.SettleAsync();
        var times = new double[StopMeasurement.Jobs];
        for (var i = 0; i < times.Length; i++)
        {
            while (desk.Session.Machine.Arming.Armed is null)
            {
                await UntilAsync(() => desk.Session.Machine.Status.State is MachineState.Ready, Task.Delay(Timeout.Infinite, CancellationToken.None));
                await desk.Queue.RunAsync("CNCARM", "Stream");
            }

            var run = desk.StartArmedAsync();
            await UntilAsync(() => desk.Session.Machine is { Status.State: MachineState.Running, Runs.Progress.SegmentsSent: > 0 }, run);
            if (run.IsCompleted) throw new InvalidOperationException("The job ended before it was stopped.");
            ear.Reset();
            times[i] = (await StopMeasurement.TimesAsync(1, () => Press(keyboard, ear.AwaitBrake)))[0];
            await run;
        }

        await output.WriteLineAsync(StopListener.Row(StopMeasurement.RunsJob, times));
    }

    /// <summary>Waits until the condition is true or the other task has ended.</summary>
    private async Task UntilAsync(Func<bool> condition, Task beside)
    {
        var held = new TaskCompletionSource();
        desk.Notifications.Changed += Look;
        Look();
        await Task.WhenAny(held.Task, beside);
        desk.Notifications.Changed -= Look;

        void Look()
        {
            if (condition()) held.TrySetResult();
        }
    }

    private static double Press(XTestKeyboard keyboard, Func<long, double> heard)
    {
        var sent = Stopwatch.GetTimestamp();
        keyboard.Send(PauseKey, down: true);
        var milliseconds = heard(sent);
        keyboard.Send(PauseKey, down: false);
        return milliseconds;
    }
}
