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
internal sealed class WindowEventLog : IDisposable
{
    private readonly ManualResetEventSlim _released = new();
    private DemoWindow? _demo;

    public InputRegions Regions { get; } = new();

    public static void WriteLine(string line)
    {
        lock (Console.Out)
        {
            Console.Out.WriteLine(line);
            Console.Out.Flush();
        }
    }

    public static bool FilterKey(in KeyPress press)
    {
        WriteLine($"filter {press.Key} {(press.IsDown ? "down" : "up")}{(press.IsRepeat ? " again" : "")} {press.Modifiers}");
        return press.Key == Key.Pause;
    }

    public void Follow(DemoWindow demo)
    {
        _demo = demo;
        demo.Counter.Click += (_, _) => WriteLine($"pressed {demo.Presses}");
        demo.Entry.TextChanged += (_, _) => WriteLine($"text {demo.Entry.Text}");
        demo.Entry.GotFocus += (_, _) => WriteLine("entry focused");
        demo.Activated += (_, _) => WriteLine("active");
        demo.Deactivated += (_, _) => WriteLine("inactive");
        demo.KeyDown += (_, e) => WriteLine($"key {e.Key}");
        demo.Closing += (_, _) => WriteLine("closing");
        demo.PointerWheelChanged += (_, e) => WriteLine($"wheel {e.Delta.X} {e.Delta.Y}");
        demo.SizeChanged += (_, e) => WriteLine($"size {e.NewSize.Width} {e.NewSize.Height}");
        demo.PropertyChanged += (_, e) => WriteChange(e);
        demo.Rows.Loaded += (_, _) => demo.Rows.GetVisualDescendants().OfType<ScrollViewer>().First().ScrollChanged += (_, _) => WriteLine("scrolled");
        DragDrop.AddDropHandler(demo, (_, e) => WriteLine("dropped " + string.Join('|', e.DataTransfer.TryGetFiles()!.Select(file => file.Path.LocalPath))));
        new Thread(ReadOrders) { IsBackground = true }.Start();
    }

    public void Dispose()
    {
        _released.Dispose();
    }

    private static void WriteChange(AvaloniaPropertyChangedEventArgs e)
    {
        if (e.Property == Window.WindowStateProperty) WriteLine($"state {e.NewValue}");
    }

    private void ReadOrders()
    {
        while (Console.In.ReadLine() is { } order)
        {
            if (order == "release") _released.Set();
            else Dispatcher.UIThread.Post(() => _ = ExecuteAsync(order), DispatcherPriority.Background);
        }
    }

    private async Task ExecuteAsync(string order)
    {
        var (verb, rest) = order.Split(' ', 2) is [var first, var second] ? (first, second) : (order, "");
        switch (verb)
        {
            case "where":
                Where();
                break;
            case "block":
                WriteLine("blocked");
                _released.Wait();
                WriteLine("released");
                break;
            case "region":
                var area = new Rect(_demo!.Counter.TranslatePoint(default, _demo)!.Value, _demo.Counter.Bounds.Size);
                Regions.Add(_demo, area, PressedInRegion);
                WriteLine("region added");
                break;
            case "copy":
                await _demo!.Clipboard!.SetTextAsync(rest);
                WriteLine("copied");
                break;
            case "copylong":
                await _demo!.Clipboard!.SetTextAsync(new string('ä', int.Parse(rest, CultureInfo.InvariantCulture)));
                WriteLine("copied");
                break;
            case "paste":
                WriteLine($"clipboard {await _demo!.Clipboard!.TryGetTextAsync()}");
                break;
            case "pastelong":
                WriteLine($"clipboard length {(await _demo!.Clipboard!.TryGetTextAsync())?.Length}");
                break;
            case "clear":
                _demo!.Entry.Clear();
                WriteLine("cleared");
                break;
            case "state":
                _demo!.WindowState = Enum.Parse<WindowState>(rest);
                break;
            case "dialog":
                await ShowDialog();
                break;
            case "cursor":
                _demo!.Cursor = new Cursor(Enum.Parse<StandardCursorType>(rest));
                WriteLine("cursor set");
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
        WriteLine("region pressed");
        return true;
    }

    private async Task ShowDialog()
    {
        var answer = new Button { Content = "Yes", IsDefault = true };
        var dialog = new Window { Title = "Question", Width = 240, Height = 120, Content = answer };
        answer.Click += (_, _) => dialog.Close("yes");
        dialog.Activated += (_, _) => WriteLine("dialog active");
        WriteLine($"dialog answered {await dialog.ShowDialog<string>(_demo!)}");
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
            else WriteLine($"animated {frames} frames of {_demo.ClientSize} in {watch.ElapsedMilliseconds} ms, processor {(Process.GetCurrentProcess().TotalProcessorTime - before).TotalMilliseconds / frames:F1} ms a frame");
        }
    }

    /// <summary>Writes the positions of the controls on the screen, in pixels.</summary>
    private void Where()
    {
        foreach (var (name, control) in new (string, Control)[] { ("counter", _demo!.Counter), ("entry", _demo.Entry), ("rows", _demo.Rows) })
        {
            var place = _demo.PointToScreen(_demo.Middle(control));
            WriteLine($"at {name} {place.X} {place.Y}");
        }

        WriteLine($"window {_demo.TryGetPlatformHandle()!.Handle}");
    }
}
