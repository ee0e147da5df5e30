using Avalonia;
using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.Input.Raw;
using Avalonia.Threading;
using Engraver.SoftwarePlatform.Input;
using Engraver.SoftwarePlatform.X11.Protocol;

namespace Engraver.SoftwarePlatform.X11;

/// <summary>A window as the event thread knows it: passes its events through the door, and queues them for the user interface.</summary>
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

    /// <summary>Set by the user interface thread; places in the input regions' units are made with it.</summary>
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
            case XEventType.DestroyNotify: // by another program; of our own doing nobody listens any more
                Queue(window.Dispose);
                break;
            case XEventType.ClientMessage when received.MessageType == desktop.Atoms.WmProtocols:
                OnProtocol(ref received);
                break;
        }
    }

    /// <summary>First the filter, then the input method, then the queue. What an input method sends back a second time is not filtered again.</summary>
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
        if (received.Detail == 0) Queue(() => window.OnText(text)); // composed elsewhere: text without a key
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
        return _lastKeyAdmitted = desktop.Door.Admits(key, MouseButtons.KeysOf(modifiers), isDown);
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
        var admitted = isDown ? desktop.Door.AdmitsPress(handle, at, button) : desktop.Door.AdmitsRelease(handle, button);
        if (!admitted) return;
        var bit = MouseButtons.HeldBit(button); // the state is that from before the event
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

    /// <summary>Grabs (a menu of the window manager) and the pointer's own comings and goings are no change of focus.</summary>
    private void OnFocus(ref XEvent received)
    {
        var has = received.Type == XEventType.FocusIn;
        if (has == _focused || received.FocusMode is NotifyGrab or NotifyUngrab || received.FocusDetail is NotifyInferior or NotifyPointer) return;
        _focused = has;
        if (!has) desktop.Door.ForgetHeldKeys();
        if (inputContext != 0 && has) Xlib.XSetICFocus(inputContext);
        if (inputContext != 0 && !has) Xlib.XUnsetICFocus(inputContext);
        Queue(() => window.OnFocus(has));
    }

    /// <summary>Of several in a row only the last matters. The place is asked for, because under a window manager the event's is that within the frame.</summary>
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

    /// <summary>A ping is answered here: while this thread lives, the window is not hung, because stopping still works.</summary>
    private void OnProtocol(ref XEvent received)
    {
        var protocol = (nint)received.Data[0];
        if (protocol == desktop.Atoms.WmDeleteWindow) Queue(window.OnCloseAsked);
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
