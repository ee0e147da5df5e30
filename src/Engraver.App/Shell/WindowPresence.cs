using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.Interactivity;
using Avalonia.Threading;
using Engraver.App.Desk;
using Engraver.Workbench.Machines;

namespace Engraver.App.Shell;

/// <summary>Sends the heartbeat of a continuous jog while the window responds and is active, whatever started the jog. Deactivating, minimising or closing
/// the window releases the jog immediately.</summary>
internal sealed class WindowPresence
{
    private readonly Window _window;
    private readonly DesktopModel _desk;
    private ITimer? _heartbeat;

    /// <summary>The window is not active: a jog that starts meanwhile gets no heartbeat.</summary>
    private bool _isAway;

    public WindowPresence(Window window, DesktopModel desk)
    {
        (_window, _desk) = (window, desk);
        window.Activated += (_, _) => _isAway = false;
        window.Deactivated += (_, _) => Leave();
        window.Closing += (_, _) => Presence.ReleaseAll(); // it may stay open if the operator is asked
        window.Closed += (_, _) => Leave();
        window.PropertyChanged += (_, change) =>
        {
            if (change.Property == Window.WindowStateProperty && _window.WindowState == WindowState.Minimized) Leave();
        };
        window.AddHandler(InputElement.KeyDownEvent, OnInput, RoutingStrategies.Tunnel, handledEventsToo: true);
        window.AddHandler(InputElement.PointerPressedEvent, OnInput, RoutingStrategies.Tunnel, handledEventsToo: true);
        desk.Notifications.Changed += Refresh;
    }

    private OperatorPresence Presence => _desk.Session.Machine.Hand.Presence;

    private void OnInput(object? sender, RoutedEventArgs e) => _isAway = false;

    private void Leave()
    {
        _isAway = true;
        Presence.ReleaseAll();
    }

    private void Refresh()
    {
        if (Presence.IsNeeded == _heartbeat is not null) return;
        _heartbeat?.Dispose();
        _heartbeat = _heartbeat is null ? _desk.Time.CreateTimer(_ => Dispatcher.UIThread.Post(SendHeartbeat, DispatcherPriority.Background), null, OperatorPresence.SignInterval, OperatorPresence.SignInterval) : null;
    }

    /// <summary>Called at a priority below the rest of the window's work, so that anything that delays that work also delays the heartbeat.</summary>
    private void SendHeartbeat()
    {
        if (!_isAway) Presence.Sign();
    }
}
