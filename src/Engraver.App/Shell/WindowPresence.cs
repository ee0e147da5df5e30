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
    private ITimer? _beat;

    /// <summary>The window is not active: a jog that starts meanwhile gets no heartbeat.</summary>
    private bool _isLeft;

    public WindowPresence(Window window, DesktopModel desk)
    {
        (_window, _desk) = (window, desk);
        window.Activated += (_, _) => _isLeft = false;
        window.Deactivated += (_, _) => Leave();
        window.Closing += (_, _) => Presence.Leave(); // it may stay open if the operator is asked
        window.Closed += (_, _) => Leave();
        window.PropertyChanged += (_, change) =>
        {
            if (change.Property == Window.WindowStateProperty && _window.WindowState == WindowState.Minimized) Leave();
        };
        window.AddHandler(InputElement.KeyDownEvent, OnHand, RoutingStrategies.Tunnel, handledEventsToo: true);
        window.AddHandler(InputElement.PointerPressedEvent, OnHand, RoutingStrategies.Tunnel, handledEventsToo: true);
        desk.Notifications.Changed += Look;
    }

    private OperatorPresence Presence => _desk.Session.Machine.Hand.Presence;

    private void OnHand(object? sender, RoutedEventArgs e) => _isLeft = false;

    private void Leave()
    {
        _isLeft = true;
        Presence.Leave();
    }

    private void Look()
    {
        if (Presence.IsNeeded == _beat is not null) return;
        _beat?.Dispose();
        _beat = _beat is null ? _desk.Time.CreateTimer(_ => Dispatcher.UIThread.Post(Sign, DispatcherPriority.Background), null, OperatorPresence.Beat, OperatorPresence.Beat) : null;
    }

    /// <summary>Called at a priority below the rest of the window's work, so that anything that delays that work also delays the heartbeat.</summary>
    private void Sign()
    {
        if (!_isLeft) Presence.Sign();
    }
}
