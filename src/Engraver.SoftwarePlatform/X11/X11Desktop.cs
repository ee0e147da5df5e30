using Avalonia;
using Engraver.SoftwarePlatform.Input;
using Engraver.SoftwarePlatform.X11.Protocol;
using Engraver.SoftwarePlatform.X11.Selections;

namespace Engraver.SoftwarePlatform.X11;

/// <summary>Shared by the windows of one application on an X server.</summary>
/// <remarks>Two connections: the input connection creates the windows and receives their events, used by the event thread only; the drawing connection
/// decorates and paints them, used by the user interface thread only. So a key reaches its filter even while the user interface is busy.</remarks>
internal sealed unsafe class X11Desktop
{
    private const int InputOnly = 2;
    private readonly XConnection _input;
    private readonly Dictionary<nint, X11WindowEvents> _windows = [];
    private readonly XdndTarget _drops;
    private readonly SelectionReader _dropReader;
    private readonly nint _helper;
    private long _screenSize;

    public X11Desktop(SoftwarePlatformOptions options, InputGate gate, Action lost)
    {
        Gate = gate;
        ApplicationName = options.ApplicationName;
        Libc.ChooseUtf8Locale();
        _input = XConnection.Open(options.DisplayName);
        Drawing = XConnection.Open(options.DisplayName);
        Cursors = new X11Cursors(Drawing);
        XErrors.LogRefusedRequests();
        Atoms = new XAtoms(_input.Display);
        Keyboard = new X11Keyboard(_input);
        Events = new XEventThread(_input, Handle, lost);
        XErrors.WhenLost(_input, Events.ReportLoss);
        XErrors.WhenLost(Drawing, Events.ReportLoss);
        _helper = MakeHelperWindow();
        Owner = new SelectionOwner(_input, Atoms, _helper);
        ClipboardReader = new SelectionReader(_input, _helper, Atoms.Clipboard, Atoms.Delivery, Atoms.Incr);
        _dropReader = new SelectionReader(_input, _helper, Atoms.XdndSelection, Atoms.DropDelivery, Atoms.Incr);
        _drops = new XdndTarget(_input, this, _dropReader);
        ScreenSize = new PixelSize(Xlib.XDisplayWidth(_input.Display, _input.Screen), Xlib.XDisplayHeight(_input.Display, _input.Screen));
        Scale = options.Scale > 0 ? options.Scale : XftDpi.ScaleOf(_input.ResourceText());
        Xlib.XSelectInput(_input.Display, _input.Root, XEventMask.StructureNotify);
        _input.Flush();
    }

    public InputGate Gate { get; }

    public XConnection Drawing { get; }

    /// <summary>For the user interface thread.</summary>
    public X11Cursors Cursors { get; }

    public XAtoms Atoms { get; }

    public X11Keyboard Keyboard { get; }

    public XEventThread Events { get; }

    public SelectionOwner Owner { get; }

    public SelectionReader ClipboardReader { get; }

    public string ApplicationName { get; }

    public double Scale { get; }

    /// <summary>The server's time of the last event, which selections require instead of "now". For the event thread.</summary>
    public nint LastEventTime { get; private set; }

    /// <summary>Follows the server's screen when that is resized. From any thread.</summary>
    public PixelSize ScreenSize
    {
        get => Interlocked.Read(ref _screenSize) is var both ? new PixelSize((int)(both >> 32), (int)both) : default;
        private set => Interlocked.Exchange(ref _screenSize, ((long)value.Width << 32) | (uint)value.Height);
    }

    /// <summary>Makes a window whose events are passed to <paramref name="window"/>. Called from the user interface thread, which waits for it.</summary>
    public X11WindowEvents Open(X11Window window, PixelSize size) =>
        Events.Invoke(() => MakeWindow(window, size)) ?? new X11WindowEvents(this, _input, 0, 0, window);

    /// <summary>Destroys a window. The drawing connection must have sent all requests for it.</summary>
    public void Close(X11WindowEvents window) => Events.Post(() =>
    {
        _windows.Remove(window.Handle);
        window.DestroyOnServer();
    });

    private X11WindowEvents MakeWindow(X11Window window, PixelSize size)
    {
        var attributes = new XSetWindowAttributes { BitGravity = XSetWindowAttributes.NorthWestGravity }; // no background, so that nothing flickers before it is drawn
        var handle = Xlib.XCreateWindow(_input.Display, _input.Root, 0, 0, (uint)size.Width, (uint)size.Height, 0, 0, 0, 0, XSetWindowAttributes.BackgroundAndGravity, &attributes);
        Xlib.XSelectInput(_input.Display, handle, XEventMask.Window);
        _input.SetLongs(handle, Atoms.XdndAware, XAtoms.Atom, XdndTarget.Version);
        var events = new X11WindowEvents(this, _input, handle, Keyboard.CreateContext(handle), window);
        _windows[handle] = events;
        _input.Sync(); // the other connection may use it from here on
        return events;
    }

    private nint MakeHelperWindow()
    {
        XSetWindowAttributes none;
        var helper = Xlib.XCreateWindow(_input.Display, _input.Root, -1, -1, 1, 1, 0, 0, InputOnly, 0, 0, &none);
        Xlib.XSelectInput(_input.Display, helper, XEventMask.PropertyChange);
        return helper;
    }

    /// <summary>On the event thread. Keys go through the input filter before the input method, which may be another program that does not
    /// respond.</summary>
    private void Handle(ref XEvent received)
    {
        if (received.Type is >= XEventType.KeyPress and <= XEventType.LeaveNotify) LastEventTime = received.Time;
        if (received.Type is XEventType.KeyPress or XEventType.KeyRelease)
        {
            if (_windows.TryGetValue(received.Window, out var keyed)) keyed.OnKey(ref received);
            return;
        }

        fixed (XEvent* given = &received)
        {
            if (Xlib.XFilterEvent(given, 0) != 0) return;
        }

        if (HandleShared(ref received)) return;
        if (_windows.TryGetValue(received.Window, out var window)) window.OnEvent(ref received);
    }

    /// <summary>Handles events that belong to no single window.</summary>
    private bool HandleShared(ref XEvent received)
    {
        switch (received.Type)
        {
            case XEventType.MappingNotify:
                fixed (XEvent* given = &received) Xlib.XRefreshKeyboardMapping(given);
                return true;
            case XEventType.SelectionRequest:
                Owner.OnRequest(ref received);
                return true;
            case XEventType.SelectionClear:
                Owner.OnCleared();
                return true;
            case XEventType.SelectionNotify:
                ClipboardReader.OnNotify(ref received);
                _dropReader.OnNotify(ref received);
                return true;
            case XEventType.PropertyNotify when !_windows.ContainsKey(received.Window):
                OnForeignProperty(ref received);
                return true;
            case XEventType.DestroyNotify when !_windows.ContainsKey(received.Window):
                Owner.OnGone(received.Window);
                return true;
            case XEventType.ConfigureNotify when received.Window == _input.Root:
                ScreenSize = new PixelSize(received.Width, received.Height);
                return true;
            case XEventType.ClientMessage:
                return _windows.TryGetValue(received.Window, out var window) && _drops.Handle(window, ref received);
            default:
                return false;
        }
    }

    private void OnForeignProperty(ref XEvent received)
    {
        if (received.PropertyState == 1) Owner.OnPropertyDeleted(received.Window, received.Property);
        else if (received.Window != _helper) return;
        else
        {
            ClipboardReader.OnPropertyNew(received.Property);
            _dropReader.OnPropertyNew(received.Property);
        }
    }
}
