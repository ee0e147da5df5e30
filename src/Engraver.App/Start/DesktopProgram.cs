using Avalonia;
using Avalonia.Controls;
using Avalonia.Controls.ApplicationLifetimes;
using Avalonia.Dialogs;
using Avalonia.Threading;
using Engraver.App.Shell;
#if AVALONIA_OWN
using Engraver.SoftwarePlatform;
using Engraver.SoftwarePlatform.Headless;
#endif

namespace Engraver.App.Start;

/// <summary>One run of the desktop. The only place that knows which platform Avalonia stands on.</summary>
public static class DesktopProgram
{
    private const int Done = 0;
    private const int Failed = 1;
    private const int NoDisplay = 6;

    /// <returns>The exit code of the runner's contract.</returns>
    public static int Run(DesktopOptions options, TextWriter error)
    {
        var session = new DesktopSession(DesktopSession.OfUser());
        try
        {
            return options.Headless ? RunHeadless(session, options, error) : RunOnDisplay(session, options, error);
        }
#if AVALONIA_OWN
        catch (DisplayUnavailableException none)
        {
            error.WriteLine($"engraver-desktop: {none.Message} Use --headless to run without a display.");
            return NoDisplay;
        }
#endif
        finally
        {
            session.DisposeAsync().AsTask().GetAwaiter().GetResult();
        }
    }

    private static int RunOnDisplay(DesktopSession session, DesktopOptions options, TextWriter error)
    {
        var lifetime = new ClassicDesktopStyleApplicationLifetime { ShutdownMode = ShutdownMode.OnMainWindowClose };
        var builder = OnDisplay(AppBuilder.Configure<App>(), session, options).WithInterFont().SetupWithLifetime(lifetime);
        var window = Open(builder, session, options);
        lifetime.MainWindow = window;
        window.Opened += async (_, _) =>
        {
            if (await DesktopStart.OpenAsync(session.Desk, options) is { } failed) error.WriteLine($"engraver-desktop: {failed}");
            if (options.Screenshot is { } path) Dispatcher.UIThread.Post(() => DesktopStart.Picture(window, window.RenderScaling, path), DispatcherPriority.Background);
        };
        return lifetime.Start([]);
    }

    private static ShellWindow Open(AppBuilder builder, DesktopSession session, DesktopOptions options)
    {
        var window = ((App)builder.Instance!).OpenShell(session.Desk, session.StopKeys);
        if (options.Size is { } size) (window.Width, window.Height) = (size.Width, size.Height);
        return window;
    }

#if AVALONIA_OWN
    private static AppBuilder OnDisplay(AppBuilder builder, DesktopSession session, DesktopOptions options) =>
        builder.UseSoftwarePlatform(PlatformOptions(session, new FrontEnd.X11(), options.Scale ?? 0.0)).UseManagedSystemDialogs();

    private static SoftwarePlatformOptions PlatformOptions(DesktopSession session, FrontEnd frontEnd, double scale) => new()
    {
        FrontEnd = frontEnd,
        Scale = scale,
        ApplicationName = "engraver-desktop",
        Filter = (in KeyPress press) => press is { IsDown: true, IsRepeat: false } && session.StopKeys.Press(press.Key, press.Modifiers),
        Regions = session.StopRegions,
    };

    /// <summary>A job on a machine may be in the script.</summary>
    private static readonly TimeSpan s_longestScript = TimeSpan.FromHours(24);

    private static int RunHeadless(DesktopSession session, DesktopOptions options, TextWriter error)
    {
        var desktop = new HeadlessDesktop();
        var builder = AppBuilder.Configure<App>().UseSoftwarePlatform(PlatformOptions(session, new FrontEnd.Headless(desktop), options.Scale ?? 1.0)).WithInterFont().UseManagedSystemDialogs().SetupWithoutStarting();
        var window = Open(builder, session, options);
        window.Show();
        desktop.Step();
        var opening = DesktopStart.OpenAsync(session.Desk, options);
        desktop.StepUntil(() => opening.IsCompleted && window.CanvasFeed.Shown.IsCompleted, s_longestScript);
        window.Canvas.RefineNow();
        desktop.Step();
        if (options.Screenshot is { } path) desktop.Windows[0].CaptureToFile(path);
        window.Close();
        if (opening.Result is not { } failed) return Done;
        error.WriteLine($"engraver-desktop: {failed}");
        return Failed;
    }
#else
    private static AppBuilder OnDisplay(AppBuilder builder, DesktopSession session, DesktopOptions options) => builder.UsePlatformDetect();

    private static int RunHeadless(DesktopSession session, DesktopOptions options, TextWriter error)
    {
        error.WriteLine("engraver-desktop: this build has no headless platform.");
        return NoDisplay;
    }
#endif
}
