using Avalonia;
using Engraver.SoftwarePlatform;
using Engraver.SoftwarePlatform.Headless;

namespace Engraver.App.Tests.Canvas;

/// <summary>The one application of this test process: the program's own, in memory.</summary>
public sealed class DesktopFixture : IDisposable
{
    public DesktopFixture() => Runner = new HeadlessRunner(
        Desktop, () => AppBuilder.Configure<App>().UseSoftwarePlatform(new SoftwarePlatformOptions { FrontEnd = new FrontEnd.Headless(Desktop) }).WithInterFont());

    public HeadlessDesktop Desktop { get; } = new();

    public HeadlessRunner Runner { get; }

    public void Dispose() => Runner.Dispose();
}
