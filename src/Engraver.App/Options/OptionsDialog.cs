using Avalonia.Controls;
using Avalonia.Threading;
using Engraver.App.Desk;

namespace Engraver.App.Options;

/// <summary>Opens the sheets of commands that have one, at the request of the command session.</summary>
internal static class OptionsDialog
{
    /// <summary>While the window is open, OPTIONS opens its sheet instead of a prompt at the command line, and QUIT closes the window.</summary>
    public static void Serve(DesktopModel desk, OptionsModel options, Window window)
    {
        desk.Session.Dialogs = Show;
        window.Closed += (_, _) => desk.Session.Dialogs = null;

        bool Show(string command)
        {
            Action? open = command switch { "OPTIONS" => options.Open, "QUIT" => window.Close, _ => null };
            if (open is not null) Dispatcher.UIThread.Post(open);
            return open is not null;
        }
    }
}
