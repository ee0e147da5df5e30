using Engraver.Galil.Protocol;

namespace Engraver.Galil.Sessions;

/// <summary>Compares the controller's sample counter with our own clock.</summary>
/// <param name="RunsAhead">The controller's time passes much faster than ours: a simulated controller faster than real time, possibly one whose time is the
/// commands it receives. Waiting between two polls would then only make the job slow.</param>
/// <param name="OursMoves">False for a clock of ours that stands: a test's.</param>
internal readonly record struct ClockComparison(bool RunsAhead, bool OursMoves)
{
    private const int Questions = 8;
    private const double MuchFaster = 3.0;

    /// <remarks>A real controller counts 1024 samples a second (galil-dmc.md C, TIME) and answers each question in more than a sample, so its ratio is near 1. One that does not know TIME is real.</remarks>
    public static async ValueTask<ClockComparison> CompareAsync(CommandChannel channel, TimeProvider time, CancellationToken cancellation)
    {
        var start = time.GetTimestamp();
        var first = (await channel.ReadWholeAsync("TIME", cancellation).ConfigureAwait(false)).OrNothing;
        var last = first;
        for (var i = 1; i < Questions; i++) last = (await channel.ReadWholeAsync("TIME", cancellation).ConfigureAwait(false)).OrNothing;
        var milliseconds = time.GetElapsedTime(start).TotalMilliseconds;
        return new ClockComparison(last - first >= Questions && last - first > MuchFaster * milliseconds, milliseconds > 0.0);
    }
}
