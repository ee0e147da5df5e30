using Avalonia;
using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.Interactivity;
using Avalonia.Markup.Xaml;
using Avalonia.Threading;
using Engraver.App.Safety;
using Engraver.App.Sessions;
using Engraver.App.Shell;
using Engraver.App.Theme;

namespace Engraver.App;

/// <summary>The operator desktop.</summary>
public partial class App : Application
{
    public override void Initialize() => AvaloniaXamlLoader.Load(this);

    /// <summary>Opens the window of a session; its theme follows the view. While it is open, the stop keys work in every window of the program, and
    /// failures of the program are reported.</summary>
    public ShellWindow OpenShell(DesktopSession session)
    {
        ArgumentNullException.ThrowIfNull(session);
        var desk = session.Desk;
        Follow();
        desk.Notifications.Changed += Follow;
        desk.Notifications.Failed += OnFailed;
        Dispatcher.UIThread.UnhandledException += OnUnhandled;
        var keys = InputElement.KeyDownEvent.AddClassHandler<Window>((_, e) => e.Handled |= PressOnce(session.StopKeys, e), RoutingStrategies.Tunnel);
        var leaving = InputElement.KeyDownEvent.AddClassHandler<Window>(LeaveDialog);
        var window = new ShellWindow(desk, session.StopKeys);
        window.Closed += (_, _) =>
        {
            keys.Dispose();
            leaving.Dispose();
            Dispatcher.UIThread.UnhandledException -= OnUnhandled;
        };
        return window;

        void Follow() => RequestedThemeVariant = DesktopThemes.Of(desk.Session.View.Current.Theme);

        void OnFailed(Exception failure) => session.Failures.Handle(failure);

        void OnUnhandled(object? sender, DispatcherUnhandledExceptionEventArgs e)
        {
            session.Failures.Handle(e.Exception);
            e.Handled = true;
        }
    }

    /// <summary>Esc closes a dialog (a file dialog too), unless it stopped the machine or closed something inside the dialog.</summary>
    private static void LeaveDialog(Window window, KeyEventArgs e)
    {
        if (e.Key != Key.Escape || window is ShellWindow || window.Owner is null) return;
        e.Handled = true;
        window.Close();
    }

    /// <summary>Passes a key to the stop keys, unless it was pressed in the shell, which handles the stop keys itself.</summary>
    private static bool PressOnce(StopKeys stopKeys, KeyEventArgs e) => TopLevel.GetTopLevel(e.Source as Visual) is not ShellWindow && stopKeys.Press(e.Key, e.KeyModifiers);
}
