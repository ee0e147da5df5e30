using Avalonia;
using Engraver.SoftwarePlatform.Headless;

namespace Engraver.SoftwarePlatform.Tests.Headless;

/// <summary>The application of this test process.</summary>
public sealed class DesktopFixture : IDisposable
{
    public DesktopFixture()
    {
        var options = new SoftwarePlatformOptions { FrontEnd = new FrontEnd.Headless(Desktop), Filter = FilterKey, Regions = Regions };
        Runner = new HeadlessRunner(Desktop, () => AppBuilder.Configure<DemoApp>().UseSoftwarePlatform(options).WithInterFont());
    }

    public HeadlessDesktop Desktop { get; } = new();

    public InputRegions Regions { get; } = new();

    public HeadlessRunner Runner { get; }

    /// <summary>The filter of the current test.</summary>
    public KeyFilter? Filter { get; set; }

    public void Dispose() => Runner.Dispose();

    /// <summary>Opens a demo window for the test, on the user interface thread, and closes all windows when the test ends.</summary>
    internal Task WithDemo(Action<DemoWindow, HeadlessWindow> test) => Runner.RunAsync(() =>
    {
        var demo = new DemoWindow();
        demo.Show();
        Desktop.Step();
        Desktop.Step();
        try
        {
            test(demo, Desktop.Windows[^1]);
        }
        finally
        {
            demo.Close();
            Desktop.Step();
            Filter = null;
        }

        return Task.CompletedTask;
    });

    private bool FilterKey(in KeyPress press) => Filter?.Invoke(press) ?? false;
}
