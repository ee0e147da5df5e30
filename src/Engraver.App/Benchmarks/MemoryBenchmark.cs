using Engraver.App.Shell;
using Engraver.App.Start;
using Engraver.SoftwarePlatform.Headless;

namespace Engraver.App.Benchmarks;

/// <summary>The benchmarks of a window in memory, by the name that <c>--benchmark</c> was given.</summary>
internal static class MemoryBenchmark
{
    public static void Run(DesktopSession session, ShellWindow window, HeadlessDesktop desktop, DesktopOptions options, TextWriter output)
    {
        var measure = new WindowBenchmark(session, window, desktop, output);
        switch (options.Benchmark)
        {
            case DesktopBenchmark.Repaint:
                measure.Repaint(options.File);
                break;
            case DesktopBenchmark.Open:
                measure.Open(options.File!);
                break;
            default:
                new StopBenchmark(session, window, desktop, options.File, output).Run();
                break;
        }
    }
}
