using Avalonia;
using Avalonia.Input;
using Avalonia.Input.Raw;
using Avalonia.Platform;

namespace Engraver.SoftwarePlatform.Windows;

/// <content>Input that has passed the input filter, on the user interface thread.</content>
public abstract partial class SoftwareWindow
{
    private readonly MouseDevice _mouse = new(new Pointer(Pointer.GetNextFreeId(), PointerType.Mouse, isPrimary: true));
    private IInputRoot? _root;
    private bool _enabled = true;

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
