using Avalonia;
using Avalonia.Controls;
using Avalonia.Controls.Platform;
using Avalonia.Input;
using Avalonia.Input.Platform;
using Avalonia.Input.Raw;
using Avalonia.Platform;
using Avalonia.Platform.Surfaces;
using Avalonia.Rendering.Composition;

namespace Engraver.SoftwarePlatform.Windows;

/// <summary>A window as Avalonia sees it, in either front end: a frame of pixels that the compositor draws into, and events that go in. All members are for
/// the user interface thread.</summary>
/// <remarks>Requests of Avalonia that have no effect here have an empty body.</remarks>
public abstract class SoftwareWindow : IWindowImpl, IFramebufferPlatformSurface
{
    private readonly Seat _seat;
    private readonly MouseDevice _mouse = new(new Pointer(Pointer.GetNextFreeId(), PointerType.Mouse, isPrimary: true));
    private IInputRoot? _root;
    private WindowFrame? _frame;
    private bool _enabled = true;
    private bool _closed;

    private protected SoftwareWindow(Seat seat, double scale, Size clientSize)
    {
        _seat = seat;
        RenderScaling = scale;
        ClientSize = clientSize;
        Surfaces = [this];
    }

    public IPlatformHandle? Handle { get; private protected init; }

    public IPlatformRenderSurface[] Surfaces { get; }

    public Compositor Compositor { get; } = AvaloniaLocator.Current.GetService(typeof(Compositor)) as Compositor
        ?? throw new InvalidOperationException("A window was made before the platform was set up.");

    public Size ClientSize { get; private protected set; }

    public double RenderScaling { get; private protected set; }

    public double DesktopScaling => RenderScaling;

    public PixelPoint Position { get; private protected set; }

    public Size? FrameSize => null;

    public Size MaxAutoSizeHint => _seat.Screens.AllScreens[0].WorkingArea.Size.ToSize(RenderScaling);

    /// <summary>The client area in pixels: rounded up, so that the last device independent unit is complete.</summary>
    public PixelSize PixelSize => InPixels(ClientSize);

    public Action<RawInputEventArgs>? Input { get; set; }

    public Action<Rect>? Paint { get; set; }

    public Action<Size, WindowResizeReason>? Resized { get; set; }

    public Action<double>? ScalingChanged { get; set; }

    public Action<WindowTransparencyLevel>? TransparencyLevelChanged { get; set; }

    public Action<object?>? PlatformSpecificSceneInfoChanged { get; set; }

    public Action? Closed { get; set; }

    public Action? LostFocus { get; set; }

    public Action<PixelPoint>? PositionChanged { get; set; }

    public Action? Activated { get; set; }

    public Action? Deactivated { get; set; }

    public Action<WindowState>? WindowStateChanged { get; set; }

    public Action? GotInputWhenDisabled { get; set; }

    public Func<WindowCloseReason, bool>? Closing { get; set; }

    public Action<bool>? ExtendClientAreaToDecorationsChanged { get; set; }

    public object? PlatformSpecificSceneInfo => null;

    public WindowTransparencyLevel TransparencyLevel => WindowTransparencyLevel.None;

    public AcrylicPlatformCompensationLevels AcrylicCompensationLevels => new(1, 1, 1);

    public bool WindowStateGetterIsUsable => true;

    public bool IsClientAreaExtendedToDecorations => false;

    public bool NeedsManagedDecorations => false;

    public PlatformRequestedDrawnDecoration RequestedDrawnDecorations => PlatformRequestedDrawnDecoration.None;

    public Thickness ExtendedMargins => default;

    public Thickness OffScreenMargin => default;

    /// <summary>Increases as windows come to the front.</summary>
    internal long Stacking { get; private set; }

    internal WindowFrame? Frame => _frame;

    private protected Seat Seat => _seat;

    public Point PointToClient(PixelPoint point) => new((point.X - Position.X) / RenderScaling, (point.Y - Position.Y) / RenderScaling);

    public PixelPoint PointToScreen(Point point) => new((int)(point.X * RenderScaling) + Position.X, (int)(point.Y * RenderScaling) + Position.Y);

    public virtual object? TryGetFeature(Type featureType)
    {
        if (featureType == typeof(IClipboard)) return AvaloniaLocator.Current.GetService(typeof(IClipboard));
        return featureType == typeof(IScreenImpl) ? _seat.Screens : null;
    }

    /// <summary>No popup windows: Avalonia then shows menus, lists and tips as overlays inside this window.</summary>
    public IPopupImpl? CreatePopup() => null;

    public IFramebufferRenderTarget CreateFramebufferRenderTarget() => new FuncFramebufferRenderTarget(LockFrame, true);

    public virtual void Dispose()
    {
        if (_closed) return;
        _closed = true;
        Closed?.Invoke();
        _mouse.Dispose();
        _frame?.Dispose();
        _frame = null;
        GC.SuppressFinalize(this);
    }

    public abstract WindowState WindowState { get; set; }

    public abstract void Show(bool activate, bool isDialog);

    public abstract void Hide();

    public abstract void Activate();

    void IWindowImpl.Resize(Size clientSize, WindowResizeReason reason) => ResizeByApplication(clientSize, reason);

    private protected abstract void ResizeByApplication(Size clientSize, WindowResizeReason reason);

    public abstract void Move(PixelPoint point);

    public virtual void SetTitle(string? title)
    {
    }

    public virtual void SetParent(IWindowImpl? parent)
    {
    }

    public virtual void SetCursor(ICursorImpl? cursor)
    {
    }

    public virtual void SetIcon(IWindowIconImpl? icon)
    {
    }

    public virtual void SetTopmost(bool value)
    {
    }

    public virtual void SetWindowDecorations(WindowDecorations enabled)
    {
    }

    public virtual void ShowTaskbarIcon(bool value)
    {
    }

    public virtual void CanResize(bool value)
    {
    }

    public virtual void SetMinMaxSize(Size minSize, Size maxSize)
    {
    }

    public virtual void BeginMoveDrag(PointerPressedEventArgs e)
    {
    }

    public virtual void BeginResizeDrag(WindowEdge edge, PointerPressedEventArgs e)
    {
    }

    public void SetCanMinimize(bool value)
    {
    }

    public void SetCanMaximize(bool value)
    {
    }

    public void SetTransparencyLevelHint(IReadOnlyList<WindowTransparencyLevel> transparencyLevels)
    {
    }

    public void SetFrameThemeVariant(PlatformThemeVariant? themeVariant)
    {
    }

    public void SetExtendClientAreaToDecorationsHint(bool extendIntoClientAreaHint)
    {
    }

    public void SetExtendClientAreaTitleBarHeightHint(double titleBarHeight)
    {
    }

    public void SetInputRoot(IInputRoot inputRoot) => _root = inputRoot;

    /// <summary>A window under a modal dialog takes no input: input brings the dialog to the front instead.</summary>
    public void SetEnabled(bool enable) => _enabled = enable;

    /// <param name="text">The text of the key, or null. It follows the key unless the key was handled, for example by a shortcut.</param>
    private protected void DeliverKey(bool isDown, Key key, RawInputModifiers modifiers, string? text)
    {
        if (_root is null || Refused()) return;
        var type = isDown ? RawKeyEventType.KeyDown : RawKeyEventType.KeyUp;
        var press = new RawKeyEventArgs(_seat.Keyboard, _seat.Now, _root, type, key, modifiers, PhysicalKey.None, text);
        Input?.Invoke(press);
        if (isDown && text is not null && !press.Handled) DeliverText(text);
    }

    /// <summary>Text without a key of its own, such as a character composed with a dead key.</summary>
    private protected void DeliverText(string text)
    {
        if (_root is null || Refused()) return;
        Input?.Invoke(new RawTextInputEventArgs(_seat.Keyboard, _seat.Now, _root, text));
    }

    private protected void DeliverPointer(RawPointerEventType type, Point at, RawInputModifiers modifiers)
    {
        if (_root is null || _closed || (!_enabled && Stopped(type))) return;
        Input?.Invoke(new RawPointerEventArgs(_mouse, _seat.Now, _root, type, at, modifiers));
    }

    /// <param name="delta">Notches: y positive up (away from the user), x positive left, as in Avalonia.</param>
    private protected void DeliverWheel(Point at, Vector delta, RawInputModifiers modifiers)
    {
        if (_root is null || Refused()) return;
        Input?.Invoke(new RawMouseWheelEventArgs(_mouse, _seat.Now, _root, at, delta, modifiers));
    }

    /// <summary>The effect of a drop on the target under the pointer; none when it refuses or the window is disabled.</summary>
    private protected DragDropEffects DeliverDrag(RawDragEventType type, Point at, IDataTransfer data, DragDropEffects offered)
    {
        if (_root is null || _closed || !_enabled) return DragDropEffects.None;
        var drag = new RawDragEvent(DragDropDevice.Instance, type, _root, at, data, offered, RawInputModifiers.None);
        Input?.Invoke(drag);
        return drag.Effects;
    }

    /// <summary>Called when the frame has been drawn, to show it.</summary>
    private protected abstract void Present(WindowFrame frame);

    private protected PixelSize InPixels(Size size) =>
        new(Math.Max(1, (int)Math.Ceiling(size.Width * RenderScaling - 1e-6)), Math.Max(1, (int)Math.Ceiling(size.Height * RenderScaling - 1e-6)));

    private protected void ComeToFront() => Stacking = _seat.NextStacking();

    /// <summary>The size for which the scene was laid out; while the window is being resized it may differ from the present size.</summary>
    private ILockedFramebuffer LockFrame(IRenderTarget.RenderTargetSceneInfo scene, out FramebufferLockProperties properties)
    {
        var kept = _frame is not null && _frame.Size == scene.Size;
        if (!kept)
        {
            _frame?.Dispose();
            _frame = new WindowFrame(scene.Size);
        }

        properties = new FramebufferLockProperties(kept);
        var frame = _frame!;
        return frame.Lock(RenderScaling, () => Present(frame));
    }

    private bool Refused()
    {
        if (_closed) return true;
        if (_enabled) return false;
        GotInputWhenDisabled?.Invoke();
        return true;
    }

    /// <summary>True when a window under a modal dialog ignores the event. Leave and release events pass, because they end what began before the dialog
    /// opened.</summary>
    private bool Stopped(RawPointerEventType type)
    {
        switch (type)
        {
            case RawPointerEventType.LeaveWindow or RawPointerEventType.LeftButtonUp or RawPointerEventType.RightButtonUp or RawPointerEventType.MiddleButtonUp:
                return false;
            case RawPointerEventType.Move:
                return true;
            default:
                GotInputWhenDisabled?.Invoke();
                return true;
        }
    }
}
