using Avalonia;
using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.Input.Raw;
using Avalonia.Media;
using Avalonia.Media.Imaging;
using Avalonia.Platform;
using Avalonia.Threading;
using Engraver.SoftwarePlatform.Input;
using Engraver.SoftwarePlatform.Windows;

namespace Engraver.SoftwarePlatform.Headless;

/// <summary>A window in memory, with methods that simulate input and read what it shows.</summary>
/// <remarks>Input methods may be called from any thread. On the user interface thread they also step the desktop, so that all effects are complete when
/// they return; from another thread they return as soon as the input has passed the key filter and is queued. Positions are in device independent units of
/// the window; modifiers are those held in addition to what the call itself does.</remarks>
public sealed class HeadlessWindow : SoftwareWindow
{
    private readonly HeadlessDesktop _desktop;
    private Size _normalSize;
    private WindowState _state;

    internal HeadlessWindow(HeadlessDesktop desktop, Seat seat, double scale) : base(seat, scale, new Size(1024, 768))
    {
        _desktop = desktop;
        Handle = new PlatformHandle(desktop.NextHandle(), "Headless");
    }

    public string Title { get; private set; } = "";

    public override WindowState WindowState
    {
        get => _state;
        set => ChangeState(value);
    }

    public override void SetTitle(string? title) => Title = title ?? "";

    public override void Show(bool activate, bool isDialog)
    {
        ComeToFront();
        _desktop.Add(this);
        if (activate) _desktop.Focus(this);
    }

    public override void Hide() => _desktop.Remove(this);

    public override void Activate()
    {
        ComeToFront();
        _desktop.Focus(this);
    }

    public override void Move(PixelPoint point)
    {
        Position = point;
        PositionChanged?.Invoke(point);
    }

    public override void Dispose()
    {
        _desktop.Remove(this);
        base.Dispose();
    }

    /// <summary>Resizes the window as the user does at its border. In device independent units.</summary>
    public void Resize(Size size)
    {
        ChangeSize(size, WindowResizeReason.User);
        _desktop.Step();
    }

    /// <summary>Simulates a move to a screen of another density: the window keeps its size in device independent units.</summary>
    public void SetScale(double scale)
    {
        RenderScaling = scale;
        ScalingChanged?.Invoke(scale);
        Resized?.Invoke(ClientSize, WindowResizeReason.DpiChange);
        _desktop.Step();
    }

    /// <summary>Simulates a click on another program's window.</summary>
    public void LoseFocus()
    {
        Seat.Gate.ForgetHeldKeys();
        _desktop.Focus(null);
        _desktop.Step();
    }

    /// <summary>Asks the window to close, as its title bar's button does.</summary>
    public void RequestClose()
    {
        if (Closing?.Invoke(WindowCloseReason.WindowClosing) != true) Dispose();
        _desktop.Step();
    }

    /// <summary>The last frame as a PNG picture.</summary>
    /// <exception cref="InvalidOperationException">No frame has been drawn yet.</exception>
    public void CapturePng(Stream output)
    {
        var frame = DrawnFrame();
        using var picture = new Bitmap(PixelFormat.Bgra8888, AlphaFormat.Premul, frame.Address, frame.Size, new Vector(96, 96), frame.Stride);
        picture.Save(output, PngBitmapEncoderOptions.Default);
    }

    public void CaptureToFile(string path)
    {
        using var file = File.Create(path);
        CapturePng(file);
    }

    /// <summary>A pixel of the last frame; a transparent one is premultiplied.</summary>
    public Color PixelAt(int x, int y)
    {
        var frame = DrawnFrame();
        return Color.FromUInt32(frame.Pixels[y * frame.Size.Width + x]);
    }

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

    internal void RaiseFocusChanged(bool has)
    {
        Dispatcher.UIThread.Post(() => (has ? Activated : LosingFocus)?.Invoke(), DispatcherPriority.Input);
    }

    private protected override void ResizeByApplication(Size clientSize, WindowResizeReason reason)
    {
        if (clientSize == ClientSize) return;
        Dispatcher.UIThread.Post(() => ChangeSize(clientSize, reason), DispatcherPriority.Send);
    }

    /// <summary>Does nothing: the frame stays where it was drawn.</summary>
    private protected override void Present(WindowFrame frame)
    {
    }

    private WindowFrame DrawnFrame() => Frame ?? throw new InvalidOperationException("No frame has been drawn yet: step the desktop first.");

    private void LosingFocus()
    {
        Deactivated?.Invoke();
        LostFocus?.Invoke();
    }

    private void ChangeSize(Size size, WindowResizeReason reason)
    {
        ClientSize = size;
        Resized?.Invoke(size, reason);
    }

    private void ChangeState(WindowState state)
    {
        if (_state == state) return;
        if (_state == WindowState.Normal) _normalSize = ClientSize;
        _state = state;
        WindowStateChanged?.Invoke(state);
        if (state is WindowState.Maximized or WindowState.FullScreen) ChangeSize(_desktop.ScreenSize.ToSize(RenderScaling), WindowResizeReason.Unspecified);
        if (state is WindowState.Normal) ChangeSize(_normalSize, WindowResizeReason.Unspecified);
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
