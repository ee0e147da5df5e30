using Avalonia;
using Engraver.App.Platforms;
using Engraver.App.Sessions;
using Engraver.App.Shell;
using Engraver.SoftwarePlatform.Headless;

namespace Engraver.Benchmarks.Desktop;

/// <summary>The benchmarks of a window in memory, by the value of <c>--benchmark</c>: time until a stop is on the wire, duration of painting and
/// opening.</summary>
/// <remarks>One of two files of the same class; the project includes the one of its back end.</remarks>
internal static class MemoryBenchmark
{
    /// <returns>The sentence of the failure; null on success.</returns>
    public static string? Run(DesktopSession session, DesktopOptions options, Func<AppBuilder, ShellWindow> open, TextWriter output)
    {
        var desktop = new HeadlessDesktop();
        var window = open(DesktopPlatform.InMemory(AppBuilder.Configure<Engraver.App.App>(), session, desktop, options.Scale ?? 1.0).WithInterFont().SetupWithoutStarting());
        window.Show();
        desktop.Step();
        Measure(session, window, desktop, options, output);
        window.Close();
        return null;
    }

    private static void Measure(DesktopSession session, ShellWindow window, HeadlessDesktop desktop, DesktopOptions options, TextWriter output)
    {
        var measure = new WindowBenchmark(session, window, desktop, output);
        switch (options.Benchmark)
        {
            case BenchmarkName.Repaint:
                measure.Repaint(options.File);
                break;
            case BenchmarkName.Open:
                measure.Open(options.File!);
                break;
            case BenchmarkName.Weight:
                new WeightBenchmark(session, window, desktop, output).Run(options.File!);
                break;
            case BenchmarkName.Plots:
                new PlotsBenchmark(session, window, desktop, output).Run(options.File!);
                break;
            case BenchmarkName.Text:
                new TextBenchmark(output).Run();
                break;
            default:
                new StopBenchmark(session, window, desktop, options.File, output).Run();
                break;
        }
    }
}
