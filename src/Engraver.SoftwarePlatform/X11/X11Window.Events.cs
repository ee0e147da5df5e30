using Avalonia;
using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.Input.Raw;
using Engraver.SoftwarePlatform.Input;

namespace Engraver.SoftwarePlatform.X11;

/// <content>Handles what the event thread has queued, in order.</content>
internal sealed partial class X11Window
{
    private bool _open = true;

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

    internal void OnCloseAsked()
    {
        if (_open && Closing?.Invoke(WindowCloseReason.WindowClosing) != true) Dispose();
    }
}
