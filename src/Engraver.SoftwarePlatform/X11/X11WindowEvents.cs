using Avalonia;
using Avalonia.Input;
using Avalonia.Input.Raw;
using Avalonia.Threading;
using Engraver.SoftwarePlatform.Input;
using Engraver.SoftwarePlatform.X11.Protocol;

namespace Engraver.SoftwarePlatform.X11;

/// <summary>A window as the event thread sees it: passes its events through the input filter, and queues them for the user interface.</summary>
internal sealed unsafe class X11WindowEvents(X11Desktop desktop, XConnection input, nint handle, nint inputContext, X11Window window)
{
    private const int NotifyGrab = 1;
    private const int NotifyUngrab = 2;
    private const int NotifyInferior = 2;
    private const int NotifyPointer = 5;
    private readonly LatestOnly<(Point At, RawInputModifiers Modifiers)> _motion = new(move => window.OnPointer(RawPointerEventType.Move, move.At, move.Modifiers));
    private readonly LatestOnly<(PixelSize Size, PixelPoint Position)> _bounds = new(bounds => window.OnConfigured(bounds.Size, bounds.Position));
    private double _scale = 1;
    private (XEventType Type, nint Time, uint Code) _lastKey;
    private bool _lastKeyAdmitted;
    private bool _focused;

    public nint Handle => handle;

    /// <summary>Set by the user interface thread; converts positions to the units of the input regions.</summary>
    public double Scale
    {
        set => Volatile.Write(ref _scale, value);
    }

    public void DestroyOnServer()
    {
        if (inputContext != 0) Xlib.XDestroyIC(inputContext);
        Xlib.XDestroyWindow(input.Display, handle);
    }

    public void OnEvent(ref XEvent received)
    {
        switch (received.Type)
        {
            case XEventType.ButtonPress or XEventType.ButtonRelease:
                OnButton(ref received);
                break;
            case XEventType.MotionNotify:
                _motion.Put((PlaceOf(received), XModifiers.FromState(received.State)));
                break;
            case XEventType.EnterNotify or XEventType.LeaveNotify:
                OnCrossing(ref received);
                break;
            case XEventType.FocusIn or XEventType.FocusOut:
                OnFocus(ref received);
                break;
            case XEventType.Expose:
                var area = new PixelRect(received.ExposeX, received.ExposeY, received.ExposeWidth, received.ExposeHeight);
                Queue(() => window.OnExposed(area));
                break;
            case XEventType.ConfigureNotify:
                OnConfigure(ref received);
                break;
            case XEventType.PropertyNotify when received.Property == desktop.Atoms.NetWmState:
                var state = XWindowState.FromList(input.GetLongs(handle, desktop.Atoms.NetWmState), desktop.Atoms);
                Queue(() => window.OnStateChanged(state));
                break;
            case XEventType.MapNotify:
                Queue(window.OnMapped);
                break;
            case XEventType.DestroyNotify: // destroyed by another program; after its own destruction the window receives no events
                Queue(window.Dispose);
                break;
            case XEventType.ClientMessage when received.MessageType == desktop.Atoms.WmProtocols:
                OnProtocol(ref received);
                break;
        }
    }

    /// <summary>First the filter, then the input method, then the queue. A key that an input method sends back is not filtered again.</summary>
    public void OnKey(ref XEvent received)
    {
        var key = desktop.Keyboard.KeyOf(ref received);
        var modifiers = XModifiers.FromState(received.State);
        var isDown = received.Type == XEventType.KeyPress;
        if (!Admits(ref received, key, modifiers, isDown)) return;
        fixed (XEvent* given = &received)
        {
            if (Xlib.XFilterEvent(given, 0) != 0) return;
        }

        var text = isDown ? desktop.Keyboard.TextOf(inputContext, ref received) : null;
        if (received.Detail == 0) Queue(() => window.OnText(text)); // composed by the input method: text without a key
        else Queue(() => window.OnKey(isDown, key, modifiers, IsShortcut(modifiers) ? null : text));
    }

    public void OnDrag(RawDragEventType type, PixelPoint root, IReadOnlyList<string> files, Action<DragDropEffects> answered) =>
        Queue(() => answered(window.OnDrag(type, root, files)));

    private static bool IsShortcut(RawInputModifiers modifiers) => (modifiers & (RawInputModifiers.Control | RawInputModifiers.Alt | RawInputModifiers.Meta)) != 0;

    private bool Admits(ref XEvent received, Key key, RawInputModifiers modifiers, bool isDown)
    {
        var identity = (received.Type, received.Time, received.Detail);
        if (received.Detail == 0) return true;
        if (identity == _lastKey) return _lastKeyAdmitted;
        _lastKey = identity;
        return _lastKeyAdmitted = desktop.Gate.Admits(key, MouseButtons.KeysOf(modifiers), isDown);
    }

    private void OnButton(ref XEvent received)
    {
        var at = PlaceOf(received);
        var modifiers = XModifiers.FromState(received.State);
        var isDown = received.Type == XEventType.ButtonPress;
        if (XButtons.WheelOf(received.Detail) is { } notches)
        {
            if (isDown) Queue(() => window.OnWheel(at, notches, modifiers));
            return;
        }

        var button = XButtons.ButtonOf(received.Detail);
        if (button == MouseButton.None) return;
        var admitted = isDown ? desktop.Gate.AdmitsPress(handle, at, button) : desktop.Gate.AdmitsRelease(handle, button);
        if (!admitted) return;
        var bit = MouseButtons.HeldBit(button); // the state is that before the event
        if (isDown) Queue(() => window.OnPointer(MouseButtons.DownEvent(button), at, modifiers | bit));
        else Queue(() => window.OnPointer(MouseButtons.UpEvent(button), at, modifiers & ~bit));
    }

    private void OnCrossing(ref XEvent received)
    {
        if (received.CrossingMode is NotifyGrab or NotifyUngrab || received.CrossingDetail == NotifyInferior) return;
        var at = PlaceOf(received);
        var modifiers = XModifiers.FromState(received.CrossingState);
        var type = received.Type == XEventType.EnterNotify ? RawPointerEventType.Move : RawPointerEventType.LeaveWindow;
        Queue(() => window.OnPointer(type, at, modifiers));
    }

    /// <summary>True for a real change of focus, which grabs (a menu of the window manager) and the pointer entering or leaving are not.</summary>
    private void OnFocus(ref XEvent received)
    {
        var has = received.Type == XEventType.FocusIn;
        if (has == _focused || received.FocusMode is NotifyGrab or NotifyUngrab || received.FocusDetail is NotifyInferior or NotifyPointer) return;
        _focused = has;
        if (!has) desktop.Gate.ForgetHeldKeys();
        if (inputContext != 0 && has) Xlib.XSetICFocus(inputContext);
        if (inputContext != 0 && !has) Xlib.XUnsetICFocus(inputContext);
        Queue(() => window.OnFocus(has));
    }

    /// <summary>Handles the last of several such events. The position is queried, because under a window manager the event's is relative to the
    /// frame.</summary>
    private void OnConfigure(ref XEvent received)
    {
        fixed (XEvent* latest = &received)
        {
            while (Xlib.XCheckTypedWindowEvent(input.Display, handle, (int)XEventType.ConfigureNotify, latest) != 0)
            {
            }
        }

        Xlib.XTranslateCoordinates(input.Display, handle, input.Root, 0, 0, out var x, out var y, out _);
        _bounds.Put((new PixelSize(received.Width, received.Height), new PixelPoint(x, y)));
    }

    /// <summary>Replies to a ping here: while this thread runs, the window does not count as hung, and stopping still works.</summary>
    private void OnProtocol(ref XEvent received)
    {
        var protocol = (nint)received.Data[0];
        if (protocol == desktop.Atoms.WmDeleteWindow) Queue(window.OnCloseRequested);
        if (protocol == desktop.Atoms.NetWmPing)
            input.SendMessage(input.Root, input.Root, desktop.Atoms.WmProtocols, XEventMask.ToWindowManager, protocol, (nint)received.Data[1], (nint)received.Data[2]);
    }

    private Point PlaceOf(in XEvent received) => new Point(received.X, received.Y) / Volatile.Read(ref _scale);

    private void Queue(Action delivered)
    {
        _motion.Seal();
        Dispatcher.UIThread.Post(delivered, DispatcherPriority.Input);
    }
}
