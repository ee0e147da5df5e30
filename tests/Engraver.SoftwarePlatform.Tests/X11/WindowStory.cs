using System.Diagnostics;
using System.Globalization;
using Avalonia;
using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.Input.Platform;
using Avalonia.Media;
using Avalonia.Threading;
using Avalonia.VisualTree;

namespace Engraver.SoftwarePlatform.Tests.X11;

/// <summary>Writes a window's events as lines of text, and reads orders as lines.</summary>
internal sealed class WindowStory : IDisposable
{
    private readonly ManualResetEventSlim _released = new();
    private DemoWindow? _demo;

    public InputRegions Regions { get; } = new();

    public static void Say(string line)
    {
        lock (Console.Out)
        {
            Console.Out.WriteLine(line);
            Console.Out.Flush();
        }
    }

    public static bool FilterKey(in KeyPress press)
    {
        Say($"filter {press.Key} {(press.IsDown ? "down" : "up")}{(press.IsRepeat ? " again" : "")} {press.Modifiers}");
        return press.Key == Key.Pause;
    }

    public void Follow(DemoWindow demo)
    {
        _demo = demo;
        demo.Counter.Click += (_, _) => Say($"pressed {demo.Presses}");
        demo.Entry.TextChanged += (_, _) => Say($"text {demo.Entry.Text}");
        demo.Entry.GotFocus += (_, _) => Say("entry focused");
        demo.Activated += (_, _) => Say("active");
        demo.Deactivated += (_, _) => Say("inactive");
        demo.KeyDown += (_, e) => Say($"key {e.Key}");
        demo.Closing += (_, _) => Say("closing");
        demo.PointerWheelChanged += (_, e) => Say($"wheel {e.Delta.X} {e.Delta.Y}");
        demo.SizeChanged += (_, e) => Say($"size {e.NewSize.Width} {e.NewSize.Height}");
        demo.PropertyChanged += (_, e) => Tell(e);
        demo.Rows.Loaded += (_, _) => demo.Rows.GetVisualDescendants().OfType<ScrollViewer>().First().ScrollChanged += (_, _) => Say("scrolled");
        DragDrop.AddDropHandler(demo, (_, e) => Say("dropped " + string.Join('|', e.DataTransfer.TryGetFiles()!.Select(file => file.Path.LocalPath))));
        new Thread(TakeOrders) { IsBackground = true }.Start();
    }

    public void Dispose()
    {
        _released.Dispose();
    }

    private static void Tell(AvaloniaPropertyChangedEventArgs e)
    {
        if (e.Property == Window.WindowStateProperty) Say($"state {e.NewValue}");
    }

    private void TakeOrders()
    {
        while (Console.In.ReadLine() is { } order)
        {
            if (order == "release") _released.Set();
            else Dispatcher.UIThread.Post(() => _ = Obey(order), DispatcherPriority.Background);
        }
    }

    private async Task Obey(string order)
    {
        var (verb, rest) = order.Split(' ', 2) is [var first, var second] ? (first, second) : (order, "");
        switch (verb)
        {
            case "where":
                Where();
                break;
            case "block":
                Say("blocked");
                _released.Wait();
                Say("released");
                break;
            case "region":
                var area = new Rect(_demo!.Counter.TranslatePoint(default, _demo)!.Value, _demo.Counter.Bounds.Size);
                Regions.Add(_demo, area, PressedInRegion);
                Say("region added");
                break;
            case "copy":
                await _demo!.Clipboard!.SetTextAsync(rest);
                Say("copied");
                break;
            case "copylong":
                await _demo!.Clipboard!.SetTextAsync(new string('ä', int.Parse(rest, CultureInfo.InvariantCulture)));
                Say("copied");
                break;
            case "paste":
                Say($"clipboard {await _demo!.Clipboard!.TryGetTextAsync()}");
                break;
            case "pastelong":
                Say($"clipboard length {(await _demo!.Clipboard!.TryGetTextAsync())?.Length}");
                break;
            case "clear":
                _demo!.Entry.Clear();
                Say("cleared");
                break;
            case "state":
                _demo!.WindowState = Enum.Parse<WindowState>(rest);
                break;
            case "dialog":
                await ShowDialog();
                break;
            case "cursor":
                _demo!.Cursor = new Cursor(Enum.Parse<StandardCursorType>(rest));
                Say("cursor set");
                break;
            case "animate":
                Animate(int.Parse(rest, CultureInfo.InvariantCulture));
                break;
            case "quit":
                _demo!.Close();
                break;
        }
    }

    private bool PressedInRegion()
    {
        Say("region pressed");
        return true;
    }

    private async Task ShowDialog()
    {
        var answer = new Button { Content = "Yes", IsDefault = true };
        var dialog = new Window { Title = "Question", Width = 240, Height = 120, Content = answer };
        answer.Click += (_, _) => dialog.Close("yes");
        dialog.Activated += (_, _) => Say("dialog active");
        Say($"dialog answered {await dialog.ShowDialog<string>(_demo!)}");
    }

    /// <summary>Paints the whole window in another colour in each frame, and reports the duration. For information only: no test compares it.</summary>
    private void Animate(int frames)
    {
        var watch = Stopwatch.StartNew();
        var before = Process.GetCurrentProcess().TotalProcessorTime;
        var left = frames;
        _demo!.RequestAnimationFrame(Paint);

        void Paint(TimeSpan time)
        {
            _demo.Background = new SolidColorBrush(Color.FromRgb((byte)left, 40, 60));
            if (--left > 0) _demo.RequestAnimationFrame(Paint);
            else Say($"animated {frames} frames of {_demo.ClientSize} in {watch.ElapsedMilliseconds} ms, processor {(Process.GetCurrentProcess().TotalProcessorTime - before).TotalMilliseconds / frames:F1} ms a frame");
        }
    }

    /// <summary>Writes the positions of the controls on the screen, in pixels.</summary>
    private void Where()
    {
        foreach (var (name, control) in new (string, Control)[] { ("counter", _demo!.Counter), ("entry", _demo.Entry), ("rows", _demo.Rows) })
        {
            var place = _demo.PointToScreen(_demo.Middle(control));
            Say($"at {name} {place.X} {place.Y}");
        }

        Say($"window {_demo.TryGetPlatformHandle()!.Handle}");
    }
}
