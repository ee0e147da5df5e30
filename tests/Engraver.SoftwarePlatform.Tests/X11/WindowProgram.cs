using Avalonia;
using Avalonia.Controls;
using Avalonia.Controls.ApplicationLifetimes;
using Avalonia.Threading;
using Engraver.SoftwarePlatform.Tests.Text;

namespace Engraver.SoftwarePlatform.Tests.X11;

/// <summary>The program with a real window: reports events on standard output, one line each, and executes orders from standard input.</summary>
internal static class WindowProgram
{
    [STAThread]
    public static int Main(string[] arguments)
    {
        if (arguments is [ShapingProgram.Argument, var text, ..]) return ShapingProgram.Run(text, arguments.Contains(ShapingProgram.WithoutLibrary));
        var scale = arguments.Length > 0 ? double.Parse(arguments[0], System.Globalization.CultureInfo.InvariantCulture) : 1.0;
        using var story = new WindowEventLog();
        var options = new SoftwarePlatformOptions
        {
            Scale = scale,
            ApplicationName = "demo",
            Filter = WindowEventLog.FilterKey,
            Regions = story.Regions,
            DisplayLost = lost => WindowEventLog.WriteLine($"lost {lost.Message}"),
        };
        try
        {
            return AppBuilder.Configure<DemoApp>().UseSoftwarePlatform(options).WithInterFont().AfterSetup(_ => Dispatcher.UIThread.Post(() => Open(story)))
                .StartWithClassicDesktopLifetime([], ShutdownMode.OnMainWindowClose);
        }
        catch (DisplayUnavailableException e)
        {
            Console.Error.WriteLine(e.Message);
            return 3;
        }
    }

    private static void Open(WindowEventLog story)
    {
        var demo = new DemoWindow();
        ((IClassicDesktopStyleApplicationLifetime)Application.Current!.ApplicationLifetime!).MainWindow = demo;
        story.Follow(demo);
        demo.Show();
    }
}
