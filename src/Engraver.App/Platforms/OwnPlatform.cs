using Avalonia;
using Engraver.App.Sessions;
using Engraver.App.Shell;
using Engraver.App.Texts;
using Engraver.SoftwarePlatform;
using Engraver.SoftwarePlatform.Headless;

namespace Engraver.App.Platforms;

/// <summary>Avalonia on the software platform of this repository: X11 windows, or windows in memory. Stop keys and the on-screen STOP are handled on the
/// thread that reads the input.</summary>
/// <remarks>One of two files of the same class; the project includes the one of its back end.</remarks>
internal static class DesktopPlatform
{
    /// <summary>Maximum duration of a script, which may run a job on a machine.</summary>
    private static readonly TimeSpan s_longestScript = TimeSpan.FromHours(24);

    /// <summary>The builder for real windows.</summary>
    public static AppBuilder OnDisplay(AppBuilder builder, DesktopSession session, DesktopOptions options) => On(builder, session, new FrontEnd.X11(), options.Scale ?? 0.0);

    /// <summary>The builder for a desktop in memory.</summary>
    public static AppBuilder InMemory(AppBuilder builder, DesktopSession session, HeadlessDesktop desktop, double scale) => On(builder, session, new FrontEnd.Headless(desktop), scale);

    /// <summary>From now on presses of the on-screen STOP are handled without the UI thread.</summary>
    public static void WatchStop(ShellWindow window, DesktopSession session)
    {
        var region = ((InputRegions)session.PlatformState!).Add(window, window.StopArea, () => session.StopKeys.PressStop());
        window.LayoutUpdated += (_, _) => region.Area = window.StopArea;
        window.Closed += (_, _) => region.Dispose();
    }

    /// <summary>Opens the window, runs the script, saves the picture, ends.</summary>
    /// <param name="onFirstFrame">Called after the first frame instead of running the script; null to run it.</param>
    /// <returns>The sentence of the failure; null on success.</returns>
    public static string? RunHeadless(DesktopSession session, DesktopOptions options, Func<AppBuilder, ShellWindow> open, Action? onFirstFrame)
    {
        var desktop = new HeadlessDesktop();
        var builder = InMemory(AppBuilder.Configure<App>(), session, desktop, options.Scale ?? 1.0).WithInterFont().SetupWithoutStarting();
        var window = open(builder);
        window.Show();
        desktop.Step();
        if (onFirstFrame is not null)
        {
            onFirstFrame();
            return null;
        }

        var opening = DesktopStart.OpenAsync(session.Desk, options);
        desktop.StepUntil(() => opening.IsCompleted && window.CanvasSource.IsCurrent, s_longestScript);
        desktop.Step(); // one layout pass, so that the picture shows what the script changed
        window.Canvas.RefineNow();
        desktop.Step();
        if (options.Screenshot is { } path) desktop.Windows[0].CaptureToFile(path);
        window.Close();
        return opening.GetAwaiter().GetResult();
    }

    /// <summary>The message for a missing display; null for every other failure.</summary>
    public static string? NoDisplay(Exception failure) => (failure as DisplayUnavailableException)?.Message;

    private static AppBuilder On(AppBuilder builder, DesktopSession session, FrontEnd frontEnd, double scale)
    {
        var regions = new InputRegions();
        session.PlatformState = regions;
        return builder.UseSoftwarePlatform(new SoftwarePlatformOptions
        {
            FrontEnd = frontEnd,
            Scale = scale,
            ApplicationName = "engraver-desktop",
            Filter = (in KeyPress press) => press is { IsDown: true, IsRepeat: false } && session.StopKeys.Press(press.Key, press.Modifiers),
            Regions = regions,
            DisplayLost = _ => Console.Error.WriteLine(Text.Get("Start.Failed", session.HandleDisplayLoss())),
        });
    }
}
