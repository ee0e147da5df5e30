using Avalonia;
using Engraver.App.Sessions;
using Engraver.App.Shell;

namespace Engraver.Benchmarks.Desktop;

/// <summary>The standard back end has no window in memory, so it cannot be measured.</summary>
/// <remarks>One of two files of the same class; the project takes the one of its back end.</remarks>
internal static class MemoryBenchmark
{
    /// <returns>The sentence that reports this.</returns>
    public static string? Run(DesktopSession session, DesktopOptions options, Func<AppBuilder, ShellWindow> open, TextWriter output) => App.Texts.Text.Get("Start.NoHeadless");
}
