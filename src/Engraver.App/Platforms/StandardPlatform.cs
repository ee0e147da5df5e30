using Avalonia;
using Engraver.App.Shell;
using Engraver.App.Sessions;

namespace Engraver.App.Platforms;

/// <summary>Avalonia on its usual back ends. Stop keys and STOP are seen by the window.</summary>
/// <remarks>One of two files of the same class; the project takes the one of its back end.</remarks>
internal static class DesktopPlatform
{
    /// <summary>The builder for real windows.</summary>
    public static AppBuilder OnDisplay(AppBuilder builder, DesktopSession session, DesktopOptions options) => builder.UsePlatformDetect();

    /// <summary>Nothing to do: the window itself sees the press.</summary>
    public static void WatchStop(ShellWindow window, DesktopSession session)
    {
    }

    /// <returns>The sentence of what failed.</returns>
    public static string? RunHeadless(DesktopSession session, DesktopOptions options, Func<AppBuilder, ShellWindow> open, Action? onFirstFrame) => Texts.Text.Get("Start.NoHeadless");

    /// <summary>Null when it was no display that failed.</summary>
    public static string? NoDisplay(Exception failure) => null;
}
