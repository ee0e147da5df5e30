using Avalonia;
using Avalonia.Controls;
using Avalonia.Controls.ApplicationLifetimes;
using Avalonia.Threading;
using Engraver.App.Platforms;
using Engraver.App.Sessions;
using Engraver.App.Shell;
using Engraver.App.Texts;
using Engraver.Benchmarks.Desktop;

namespace Engraver.App.Start;

/// <summary>One run of the desktop.</summary>
public static class DesktopProgram
{
    private const int Done = 0;
    private const int Failed = 1;
    private const int Stopped = 5;
    private const int NoDisplay = 6;

    /// <summary>Maximum wait for the machine after a thread of the program has failed, so that a machine that does not answer cannot keep the program
    /// running.</summary>
    private static readonly TimeSpan s_shutdownTimeout = TimeSpan.FromSeconds(5);

    /// <returns>The exit code; see docs/cli-contract.md.</returns>
    public static int Run(DesktopOptions options, TextWriter error)
    {
        if (options.Benchmark is not (null or BenchmarkName.Start or BenchmarkName.Idle or BenchmarkName.StopOnDisplay or BenchmarkName.Frames)) return Report(DesktopBenchmark.Run(options, Console.Out), error);
        var session = new DesktopSession(options.Headless ? DesktopSession.WithoutFiles() : DesktopSession.ForUser());
        using var language = DesktopLanguage.Apply(DesktopLanguage.Choose(options.Culture, session.Language, options.Headless ? [] : DesktopLanguage.OfSystem()));
        AppDomain.CurrentDomain.UnhandledException += EndWithMachineStopped;
        try
        {
            return options.Headless ? RunHeadless(session, options, error) : RunOnDisplay(session, options, error);
        }
        catch (Exception none) when (DesktopPlatform.NoDisplay(none) is not null)
        {
            error.WriteLine(Text.Get("Start.NoDisplay", DesktopPlatform.NoDisplay(none)));
            return NoDisplay;
        }
        finally
        {
            AppDomain.CurrentDomain.UnhandledException -= EndWithMachineStopped;
            session.DisposeAsync().AsTask().GetAwaiter().GetResult();
        }

        // A thread of the program has failed and .NET is about to end the process: the machine is stopped first.
        void EndWithMachineStopped(object sender, UnhandledExceptionEventArgs e)
        {
            if (e.ExceptionObject is Exception failure) error.WriteLine(Text.Get("Start.Failed", session.Failures.Handle(failure) ?? failure.Message));
            session.DisposeAsync().AsTask().Wait(s_shutdownTimeout);
        }
    }

    private static int RunHeadless(DesktopSession session, DesktopOptions options, TextWriter error)
    {
        using var signals = new EndSignals(() => session.StopKeys.PressStop(), Cancel);
        var failure = DesktopPlatform.RunHeadless(session, options, builder => Open(builder, session, options), options.Benchmark is null ? null : DesktopBenchmark.ReportFirstFrame);
        return signals.WasReceived ? Stopped : Report(failure, error);

        void Cancel()
        {
            if (Application.Current is not null) Dispatcher.UIThread.Post(async () => await session.Desk.Queue.CancelAsync());
        }
    }

    /// <returns>The exit code for a failure; null is success.</returns>
    private static int Report(string? failure, TextWriter error)
    {
        if (failure is not { } failed) return Done;
        error.WriteLine(Text.Get("Start.Failed", failed));
        return Failed;
    }

    private static int RunOnDisplay(DesktopSession session, DesktopOptions options, TextWriter error)
    {
        var lifetime = new ClassicDesktopStyleApplicationLifetime { ShutdownMode = ShutdownMode.OnMainWindowClose };
        var builder = DesktopPlatform.OnDisplay(AppBuilder.Configure<App>(), session, options).WithInterFont().SetupWithLifetime(lifetime);
        var window = Open(builder, session, options);
        lifetime.MainWindow = window;
        if (options.Benchmark == BenchmarkName.Start) DesktopBenchmark.EndAfterFirstFrame(window);
        window.Opened += async (_, _) =>
        {
            if (await DesktopStart.OpenAsync(session.Desk, options) is { } failed) await error.WriteLineAsync(Text.Get("Start.Failed", failed));
            while (!window.CanvasSource.IsCurrent) await Dispatcher.UIThread.InvokeAsync(() => window.CanvasSource.Shown, DispatcherPriority.Background);
            window.Canvas.RefineNow();
            await DesktopBenchmark.MeasureAsync(options.Benchmark, session, window, options.File, Console.Out);
            if (options.Screenshot is { } path) Dispatcher.UIThread.Post(() => DesktopStart.SavePicture(window, window.RenderScaling, path), DispatcherPriority.Background);
        };
        using var signals = new EndSignals(() => session.StopKeys.PressStop(), () => Dispatcher.UIThread.Post(() => lifetime.Shutdown(Stopped)));
        return lifetime.Start([]);
    }

    private static ShellWindow Open(AppBuilder builder, DesktopSession session, DesktopOptions options)
    {
        var window = ((App)builder.Instance!).OpenShell(session);
        if (options.Size is { } size) (window.Width, window.Height) = (size.Width, size.Height);
        window.Opened += (_, _) => DesktopPlatform.WatchStop(window, session);
        return window;
    }
}
