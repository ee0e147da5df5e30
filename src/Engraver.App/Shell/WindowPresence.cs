using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.Interactivity;
using Avalonia.Threading;
using Engraver.App.Desk;
using Engraver.Workbench.Machines;

namespace Engraver.App.Shell;

/// <summary>Says for the window that it lives and is before the operator, as long as a continuous jog needs it, whichever way it was begun. A window that
/// is left, made small or closed releases the jog at once.</summary>
internal sealed class WindowPresence
{
    private readonly Window _window;
    private readonly DesktopModel _desk;
    private ITimer? _beat;

    /// <summary>The operator is elsewhere: a jog that begins meanwhile gets no sign.</summary>
    private bool _isLeft;

    public WindowPresence(Window window, DesktopModel desk)
    {
        (_window, _desk) = (window, desk);
        window.Activated += (_, _) => _isLeft = false;
        window.Deactivated += (_, _) => Leave();
        window.Closing += (_, _) => Presence.Leave(); // it may stay open, where the operator is asked
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

    /// <summary>From behind the rest of the window's work: what keeps that up keeps the sign up.</summary>
    private void Sign()
    {
        if (!_isLeft) Presence.Sign();
    }
}
