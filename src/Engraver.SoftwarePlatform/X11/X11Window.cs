using Avalonia;
using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.Input.Raw;
using Avalonia.Platform;
using Avalonia.Threading;
using Engraver.SoftwarePlatform.Input;
using Engraver.SoftwarePlatform.Windows;
using Engraver.SoftwarePlatform.X11.Protocol;

namespace Engraver.SoftwarePlatform.X11;

/// <summary>A window on an X server, used by the user interface thread: its requests go over the drawing connection; <see cref="X11WindowEvents"/> queues its
/// events, which the On methods handle in order.</summary>
internal sealed class X11Window : SoftwareWindow
{
    private readonly X11Desktop _desktop;
    private readonly X11WindowEvents _events;
    private readonly X11Presenter _presenter;
    private readonly WindowProperties _properties;
    private bool _open = true;
    private bool _shown;
    private WindowState _state;

    public X11Window(X11Desktop desktop, Seat seat) : base(seat, desktop.Scale, new Size(800, 600))
    {
        _desktop = desktop;
        _events = desktop.Open(this, PixelSize);
        _events.Scale = desktop.Scale;
        _presenter = new X11Presenter(desktop.Drawing, Id);
        _properties = new WindowProperties(desktop, Id);
        Handle = new PlatformHandle(Id, "XID");
        _properties.Introduce();
        _properties.Hints.Size = PixelSize;
    }

    public override WindowState WindowState
    {
        get => _state;
        set => RequestState(value);
    }

    private nint Id => _events.Handle;

    public override void SetTitle(string? title) => _properties.SetTitle(title ?? "");

    public override void SetIcon(IWindowIconImpl? icon) => _properties.SetIcon((icon as Windows.WindowIcon)?.Picture);

    public override void SetParent(IWindowImpl? parent) => Xlib.XSetTransientForHint(_desktop.Drawing.Display, Id, (parent as X11Window)?.Id ?? 0);

    public override void SetTopmost(bool value) => _properties.ChangeState(_shown, value, _desktop.Atoms.NetWmStateAbove);

    public override void ShowTaskbarIcon(bool value) => _properties.ChangeState(_shown, !value, _desktop.Atoms.NetWmStateSkipTaskbar);

    public override void SetWindowDecorations(WindowDecorations enabled) => _properties.SetDecorations(enabled != WindowDecorations.None);

    public override void CanResize(bool value)
    {
        _properties.Hints.CanResize = value;
        _properties.SendHints();
    }

    public override void SetMinMaxSize(Size minSize, Size maxSize)
    {
        _properties.Hints.SetLimits(minSize, maxSize, RenderScaling);
        _properties.SendHints();
    }

    public override void SetCursor(ICursorImpl? cursor)
    {
        Xlib.XDefineCursor(_desktop.Drawing.Display, Id, _desktop.Cursors.Of(cursor as SoftwareCursor));
        _desktop.Drawing.Flush();
    }

    public override void Show(bool activate, bool isDialog)
    {
        ComeToFront();
        _properties.SetType(isDialog);
        if (isDialog) _properties.ChangeState(_shown, true, _desktop.Atoms.NetWmStateModal);
        _properties.SendHints();
        _shown = true;
        Xlib.XMapRaised(_desktop.Drawing.Display, Id);
        _desktop.Drawing.Flush();
    }

    public override void Hide()
    {
        _shown = false;
        Xlib.XWithdrawWindow(_desktop.Drawing.Display, Id, _desktop.Drawing.Screen);
        _desktop.Drawing.Flush();
    }

    public override void Activate()
    {
        ComeToFront();
        Xlib.XRaiseWindow(_desktop.Drawing.Display, Id);
        if (_shown) _properties.RequestFocus();
        _desktop.Drawing.Flush();
    }

    public override void Move(PixelPoint point)
    {
        _properties.Hints.Position = point;
        _properties.SendHints();
        Xlib.XMoveWindow(_desktop.Drawing.Display, Id, point.X, point.Y);
        _desktop.Drawing.Flush();
    }

    public override void Dispose()
    {
        base.Dispose();
        if (!_open) return;
        _open = false;
        _presenter.Dispose();
        _desktop.Drawing.Sync(); // no request may arrive for the window after it is destroyed
        _desktop.Close(_events);
    }

    internal void OnKey(bool isDown, Key key, RawInputModifiers modifiers, string? text) => DeliverKey(isDown, key, modifiers, text);

    internal void OnText(string? text)
    {
        if (text is not null) DeliverText(text);
    }

    internal void OnPointer(RawPointerEventType type, Point at, RawInputModifiers modifiers) => DeliverPointer(type, at, modifiers);

    internal void OnWheel(Point at, Vector notches, RawInputModifiers modifiers) => DeliverWheel(at, notches, modifiers);

    internal DragDropEffects OnDrag(RawDragEventType type, PixelPoint root, IReadOnlyList<string> files) =>
        DeliverDrag(type, PointToClient(root), DroppedFiles.Create(files), DragDropEffects.Copy);

    internal void OnFocus(bool has)
    {
        if (!_open) return;
        if (has)
        {
            ComeToFront();
            Activated?.Invoke();
            return;
        }

        Deactivated?.Invoke();
        LostFocus?.Invoke();
    }

    /// <summary>Takes the keyboard focus for a new window when there is no window manager to give it.</summary>
    internal void OnMapped()
    {
        if (_open && !_properties.IsManaged) Activate();
    }

    internal void OnExposed(PixelRect area)
    {
        if (!_open) return;
        if (Frame is { } frame) _presenter.SendAgain(frame, area);
        else Paint?.Invoke(new Rect(ClientSize));
    }

    internal void OnConfigured(PixelSize size, PixelPoint position)
    {
        if (!_open) return;
        if (position != Position)
        {
            Position = position;
            PositionChanged?.Invoke(position);
        }

        if (size == PixelSize) return;
        ClientSize = size.ToSize(RenderScaling);
        Resized?.Invoke(ClientSize, WindowResizeReason.User);
    }

    internal void OnStateChanged(WindowState state)
    {
        if (!_open || state == _state) return;
        _state = state;
        WindowStateChanged?.Invoke(state);
    }

    internal void OnCloseRequested()
    {
        if (_open && Closing?.Invoke(WindowCloseReason.WindowClosing) != true) Dispose();
    }

    private protected override void ResizeByApplication(Size clientSize, WindowResizeReason reason)
    {
        if (clientSize == ClientSize) return;
        ClientSize = clientSize;
        _properties.Hints.Size = PixelSize;
        _properties.SendHints();
        Xlib.XResizeWindow(_desktop.Drawing.Display, Id, (uint)PixelSize.Width, (uint)PixelSize.Height);
        _desktop.Drawing.Flush();
        Dispatcher.UIThread.Post(() => Resized?.Invoke(clientSize, reason), DispatcherPriority.Send);
    }

    private protected override void Present(WindowFrame frame) => _presenter.Send(frame);

    private void RequestState(WindowState state)
    {
        if (state == _state) return;
        var before = _state;
        _state = state;
        var atoms = _desktop.Atoms;
        if (before == WindowState.Maximized || state == WindowState.Maximized)
            _properties.ChangeState(_shown, state == WindowState.Maximized, atoms.NetWmStateMaximizedHorizontally, atoms.NetWmStateMaximizedVertically);
        if (before == WindowState.FullScreen || state == WindowState.FullScreen) _properties.ChangeState(_shown, state == WindowState.FullScreen, atoms.NetWmStateFullscreen);
        if (state == WindowState.Minimized) Xlib.XIconifyWindow(_desktop.Drawing.Display, Id, _desktop.Drawing.Screen);
        else if (before == WindowState.Minimized && _shown) Xlib.XMapRaised(_desktop.Drawing.Display, Id);
        _desktop.Drawing.Flush();
    }
}
