using System.Collections.Immutable;
using System.Diagnostics;
using Avalonia;
using Avalonia.Input;
using Avalonia.Input.Platform;
using Avalonia.Threading;
using Engraver.SoftwarePlatform.Windows;

namespace Engraver.SoftwarePlatform.Headless;

/// <summary>The desktop in memory of one application: its windows, its clipboard, and the trigger of its frames.</summary>
/// <remarks>Step on the user interface thread only; the list of windows may be read from any.</remarks>
public sealed class HeadlessDesktop
{
    private static readonly TimeSpan FrameTime = TimeSpan.FromSeconds(1.0 / 60);
    private static readonly TimeSpan s_shortestWait = TimeSpan.FromMilliseconds(1);
    private ImmutableList<HeadlessWindow> _windows = [];
    private SoftwareDispatcher? _dispatcher;
    private ManualRenderTimer? _frames;
    private MemoryClipboard? _clipboard;
    private nint _lastHandle;

    /// <param name="time">The clock of dispatcher timers and of input; null for the system's. Avalonia's transitions always use the computer's clock.</param>
    public HeadlessDesktop(TimeProvider? time = null) => Time = time ?? TimeProvider.System;

    /// <summary>The windows that are shown, oldest first.</summary>
    public IReadOnlyList<HeadlessWindow> Windows => _windows;

    /// <summary>The window with the keyboard focus, or null.</summary>
    public HeadlessWindow? ActiveWindow { get; private set; }

    public PixelSize ScreenSize { get; init; } = new(1920, 1080);

    /// <summary>The clipboard's text; null when it is empty or holds something else.</summary>
    public string? ClipboardText
    {
        get => ReadClipboardText();
        set => WriteClipboardText(value);
    }

    internal TimeProvider Time { get; }

    private SoftwareDispatcher Loop => _dispatcher ?? throw new InvalidOperationException("The desktop is not in use yet: set the application up first.");

    /// <summary>Does all work that is due, draws it, and does the resulting work: afterwards the windows show everything requested before.</summary>
    /// <remarks>Avalonia passes its changes to the renderer in one batch at a time, and an earlier batch may still be pending: then the new changes are
    /// drawn with the second frame.</remarks>
    public void Step()
    {
        Dispatcher.UIThread.VerifyAccess();
        Loop.RunDue();
        Dispatcher.UIThread.RunJobs();
        Draw();
        if (_frames!.IsWanted) Draw();
    }

    /// <summary>Steps until the condition is true; between steps it waits for what the dispatcher waits for, and draws 60 frames a second during an
    /// animation.</summary>
    /// <exception cref="TimeoutException">The condition did not become true within the timeout (by the computer's clock).</exception>
    public void StepUntil(Func<bool> condition, TimeSpan timeout)
    {
        ArgumentNullException.ThrowIfNull(condition);
        var watch = Stopwatch.StartNew();
        while (true)
        {
            Step();
            if (condition()) return;
            var left = timeout - watch.Elapsed;
            if (left <= TimeSpan.Zero) throw new TimeoutException($"The condition did not come to hold within {timeout.TotalSeconds} s.");
            var rest = left > s_shortestWait ? left : s_shortestWait; // a wait shorter than the clock's resolution would not wait at all
            Loop.WaitForWork(_frames!.IsWanted && left > FrameTime ? FrameTime : rest, CancellationToken.None);
        }
    }

    internal void Attach(SoftwareDispatcher dispatcher, ManualRenderTimer frames, MemoryClipboard clipboard)
    {
        if (_dispatcher is not null) throw new InvalidOperationException("A desktop serves one application.");
        _dispatcher = dispatcher;
        _frames = frames;
        _clipboard = clipboard;
    }

    internal nint NextHandle() => ++_lastHandle;

    internal void Add(HeadlessWindow window)
    {
        if (!_windows.Contains(window)) _windows = _windows.Add(window);
    }

    internal void Remove(HeadlessWindow window)
    {
        _windows = _windows.Remove(window);
        if (ActiveWindow == window) Focus(_windows.MaxBy(left => left.Stacking));
    }

    internal void Focus(HeadlessWindow? window)
    {
        if (ActiveWindow == window) return;
        var before = ActiveWindow;
        ActiveWindow = window;
        before?.RaiseFocusChanged(false);
        window?.RaiseFocusChanged(true);
    }

    private void Draw()
    {
        _frames!.Fire();
        Dispatcher.UIThread.RunJobs();
    }

    /// <summary>Reads text on this clipboard, which is available at once without waiting.</summary>
    private string? ReadClipboardText()
    {
        var data = _clipboard?.TryGetDataAsync().Result;
        return data?.TryGetTextAsync() is { IsCompletedSuccessfully: true } text ? text.Result : null;
    }

    private void WriteClipboardText(string? value)
    {
        var data = new DataTransfer();
        if (value is not null) data.Add(DataTransferItem.CreateText(value));
        _clipboard?.SetDataAsync(data);
    }
}
