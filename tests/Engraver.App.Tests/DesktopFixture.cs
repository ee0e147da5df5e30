using System.Globalization;
using Avalonia;
using Engraver.SoftwarePlatform;
using Engraver.SoftwarePlatform.Headless;
using Engraver.TestKit;

namespace Engraver.App.Tests;

/// <summary>The application of this test process: the real one, on a desktop in memory.</summary>
public sealed class DesktopFixture : IDisposable
{
    public DesktopFixture()
    {
        var options = new SoftwarePlatformOptions { FrontEnd = new FrontEnd.Headless(Desktop), Filter = FilterKey, Regions = Regions };
        Runner = new HeadlessRunner(Desktop, () => AppBuilder.Configure<App>().UseSoftwarePlatform(options).WithInterFont());
    }

    public HeadlessDesktop Desktop { get; } = new();

    public InputRegions Regions { get; } = new();

    public HeadlessRunner Runner { get; }

    internal Operator? Operator { get; private set; }

    public void Dispose() => Runner.Dispose();

    /// <summary>Creates an operator with a new window, on the user interface thread, and closes everything when the test ends.</summary>
    /// <param name="test">The actions of the operator.</param>
    /// <param name="folder">The folder of settings and journals; null is a folder that is deleted afterwards.</param>
    /// <param name="language">The language of the window; null is English.</param>
    /// <param name="clock">By which machine and session go; a <see cref="ManualTimeProvider"/> moves while the operator waits. Null is the wall's.</param>
    /// <param name="workFolder">The folder of the operator's drawings; null is the samples.</param>
    internal Task WithOperator(Action<Operator> test, string? folder = null, CultureInfo? language = null, TimeProvider? clock = null, string? workFolder = null) => Runner.RunAsync(() =>
    {
        var spoken = CultureInfo.CurrentUICulture;
        CultureInfo.CurrentUICulture = language ?? spoken;
        var kept = folder ?? Directory.CreateTempSubdirectory("desktop-").FullName;
        Operator = new Operator(this, kept, clock, workFolder);
        var failed = true;
        try
        {
            test(Operator);
            failed = false;
        }
        finally
        {
            Leave(Operator, failed);
            Operator = null;
            CultureInfo.CurrentUICulture = spoken;
            if (folder is null) Directory.Delete(kept, recursive: true);
        }

        return Task.CompletedTask;
    });

    /// <param name="failed">The test has failed with its own exception, which is more useful than a window that does not close.</param>
    private static void Leave(Operator here, bool failed)
    {
        try
        {
            here.Leave();
        }
        catch (TimeoutException) when (failed)
        {
            // Whatever was running when the test failed may still run.
        }
    }

    private bool FilterKey(in KeyPress press) => press is { IsDown: true, IsRepeat: false } && Operator is { } here && here.Session.StopKeys.Press(press.Key, press.Modifiers);
}
