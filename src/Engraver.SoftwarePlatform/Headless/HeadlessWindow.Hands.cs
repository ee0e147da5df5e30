using Avalonia;
using Avalonia.Input;
using Avalonia.Input.Raw;
using Avalonia.Threading;
using Engraver.SoftwarePlatform.Input;

namespace Engraver.SoftwarePlatform.Headless;

/// <content>Simulated input: positions in device independent units of the window. Modifiers are those held in addition to what the call itself does.</content>
public sealed partial class HeadlessWindow
{
    public void MovePointer(Point at, RawInputModifiers modifiers = RawInputModifiers.None) =>
        Queue(() => DeliverPointer(RawPointerEventType.Move, at, modifiers));

    public void LeavePointer() => Queue(() => DeliverPointer(RawPointerEventType.LeaveWindow, new Point(-1, -1), RawInputModifiers.None));

    public void PressButton(Point at, MouseButton button = MouseButton.Left, RawInputModifiers modifiers = RawInputModifiers.None)
    {
        if (!Seat.Gate.AdmitsPress(Handle!.Handle, at, button)) return;
        Queue(() => DeliverPointer(MouseButtons.DownEvent(button), at, modifiers | MouseButtons.HeldBit(button)));
    }

    public void ReleaseButton(Point at, MouseButton button = MouseButton.Left, RawInputModifiers modifiers = RawInputModifiers.None)
    {
        if (!Seat.Gate.AdmitsRelease(Handle!.Handle, button)) return;
        Queue(() => DeliverPointer(MouseButtons.UpEvent(button), at, modifiers & ~MouseButtons.HeldBit(button)));
    }

    public void Click(Point at, MouseButton button = MouseButton.Left, RawInputModifiers modifiers = RawInputModifiers.None)
    {
        MovePointer(at, modifiers);
        PressButton(at, button, modifiers);
        ReleaseButton(at, button, modifiers);
    }

    public void DoubleClick(Point at, MouseButton button = MouseButton.Left, RawInputModifiers modifiers = RawInputModifiers.None)
    {
        Click(at, button, modifiers);
        PressButton(at, button, modifiers);
        ReleaseButton(at, button, modifiers);
    }

    /// <summary>Pressed at one point, moved in <paramref name="steps"/> equal steps, released at the other.</summary>
    public void Drag(Point from, Point to, int steps = 4, MouseButton button = MouseButton.Left, RawInputModifiers modifiers = RawInputModifiers.None)
    {
        MovePointer(from, modifiers);
        PressButton(from, button, modifiers);
        for (var i = 1; i <= steps; i++) MovePointer(from + (to - from) * i / steps, modifiers | MouseButtons.HeldBit(button));
        ReleaseButton(to, button, modifiers);
    }

    /// <param name="at">Position of the pointer.</param>
    /// <param name="notches">Y positive is away from the user, which scrolls up.</param>
    /// <param name="modifiers">The keys held.</param>
    public void Wheel(Point at, Vector notches, RawInputModifiers modifiers = RawInputModifiers.None) => Queue(() => DeliverWheel(at, notches, modifiers));

    public void KeyDown(Key key, RawInputModifiers modifiers = RawInputModifiers.None) => SendKey(true, key, modifiers, null);

    public void KeyUp(Key key, RawInputModifiers modifiers = RawInputModifiers.None) => SendKey(false, key, modifiers, null);

    public void Press(Key key, RawInputModifiers modifiers = RawInputModifiers.None)
    {
        KeyDown(key, modifiers);
        KeyUp(key, modifiers);
    }

    /// <summary>Types characters one by one, each with its key where a US keyboard has one.</summary>
    public void Type(string text)
    {
        ArgumentNullException.ThrowIfNull(text);
        foreach (var rune in text.EnumerateRunes())
        {
            var key = CharacterKeys.KeyOf(rune.Value);
            SendKey(true, key, RawInputModifiers.None, rune.ToString());
            SendKey(false, key, RawInputModifiers.None, null);
        }
    }

    /// <summary>Files or folders dragged from another program and released here.</summary>
    public DragDropEffects DropFiles(Point at, IEnumerable<string> paths)
    {
        var data = DroppedFiles.Create(paths);
        var effects = DragDropEffects.None;
        Queue(() => DeliverDrag(RawDragEventType.DragEnter, at, data, DragDropEffects.Copy));
        Queue(() => DeliverDrag(RawDragEventType.DragOver, at, data, DragDropEffects.Copy));
        Queue(() => effects = DeliverDrag(RawDragEventType.Drop, at, data, DragDropEffects.Copy));
        return effects;
    }

    private void SendKey(bool isDown, Key key, RawInputModifiers modifiers, string? text)
    {
        if (!Seat.Gate.Admits(key, MouseButtons.KeysOf(modifiers), isDown)) return;
        Queue(() => DeliverKey(isDown, key, modifiers, text));
    }

    private void Queue(Action delivered)
    {
        Dispatcher.UIThread.Post(delivered, DispatcherPriority.Input);
        if (Dispatcher.UIThread.CheckAccess()) _desktop.Step();
    }
}
