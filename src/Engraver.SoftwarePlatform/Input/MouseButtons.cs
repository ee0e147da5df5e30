using Avalonia.Input;
using Avalonia.Input.Raw;

namespace Engraver.SoftwarePlatform.Input;

/// <summary>The raw events and modifier bits that belong to each mouse button.</summary>
internal static class MouseButtons
{
    public static RawPointerEventType DownEvent(MouseButton button) => button switch
    {
        MouseButton.Right => RawPointerEventType.RightButtonDown,
        MouseButton.Middle => RawPointerEventType.MiddleButtonDown,
        MouseButton.XButton1 => RawPointerEventType.XButton1Down,
        MouseButton.XButton2 => RawPointerEventType.XButton2Down,
        _ => RawPointerEventType.LeftButtonDown,
    };

    public static RawPointerEventType UpEvent(MouseButton button) => button switch
    {
        MouseButton.Right => RawPointerEventType.RightButtonUp,
        MouseButton.Middle => RawPointerEventType.MiddleButtonUp,
        MouseButton.XButton1 => RawPointerEventType.XButton1Up,
        MouseButton.XButton2 => RawPointerEventType.XButton2Up,
        _ => RawPointerEventType.LeftButtonUp,
    };

    /// <summary>The bit for the held button.</summary>
    public static RawInputModifiers HeldBit(MouseButton button) => button switch
    {
        MouseButton.Right => RawInputModifiers.RightMouseButton,
        MouseButton.Middle => RawInputModifiers.MiddleMouseButton,
        MouseButton.XButton1 => RawInputModifiers.XButton1MouseButton,
        MouseButton.XButton2 => RawInputModifiers.XButton2MouseButton,
        MouseButton.Left => RawInputModifiers.LeftMouseButton,
        _ => RawInputModifiers.None,
    };

    public static KeyModifiers KeysOf(RawInputModifiers modifiers) => (KeyModifiers)(modifiers & RawInputModifiers.KeyboardMask);
}
