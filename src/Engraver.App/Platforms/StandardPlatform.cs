using Avalonia;
using Engraver.App.Sessions;
using Engraver.App.Shell;

namespace Engraver.App.Platforms;

/// <summary>Avalonia on its usual back ends. Stop keys and STOP are handled by the window.</summary>
/// <remarks>One of two files of the same class; the project includes the one of its back end.</remarks>
internal static class DesktopPlatform
{
    /// <summary>The builder for real windows.</summary>
    public static AppBuilder OnDisplay(AppBuilder builder, DesktopSession session, DesktopOptions options) => builder.UsePlatformDetect();

    /// <summary>Nothing to do: the window itself handles the press.</summary>
    public static void WatchStop(ShellWindow window, DesktopSession session)
    {
    }

    /// <returns>The sentence of the failure.</returns>
    public static string? RunHeadless(DesktopSession session, DesktopOptions options, Func<AppBuilder, ShellWindow> open, Action? onFirstFrame) => Texts.Text.Get("Start.NoHeadless");

    /// <summary>Null unless the failure is a missing display.</summary>
    public static string? NoDisplay(Exception failure) => null;
}
