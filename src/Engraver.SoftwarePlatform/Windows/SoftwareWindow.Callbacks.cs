using Avalonia;
using Avalonia.Controls;
using Avalonia.Controls.Platform;
using Avalonia.Input;
using Avalonia.Input.Raw;
using Avalonia.Platform;

namespace Engraver.SoftwarePlatform.Windows;

/// <content>Avalonia's callbacks, and requests that have no effect here.</content>
public abstract partial class SoftwareWindow
{
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
}
