using Avalonia;
using Engraver.App.Sessions;
using Engraver.App.Shell;

namespace Engraver.Benchmarks.Desktop;

/// <summary>The standard back end has no windows in memory, so that these benchmarks are not available.</summary>
/// <remarks>One of two files of the same class; the project includes the one of its back end.</remarks>
internal static class MemoryBenchmark
{
    /// <returns>The sentence that states so.</returns>
    public static string? Run(DesktopSession session, DesktopOptions options, Func<AppBuilder, ShellWindow> open, TextWriter output) => App.Texts.Text.Get("Start.NoHeadless");
}
