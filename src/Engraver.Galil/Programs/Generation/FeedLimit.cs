using Engraver.Galil.Language;

namespace Engraver.Galil.Programs.Generation;

/// <summary>The speeds at which the host can still send a long sequence: a segment needs about 2 ms, and a buffer that runs dry stops the machine at once
/// (galil-dmc.md B.7).</summary>
internal static class FeedLimit
{
    /// <summary>A sequence of up to this many segments is in the buffer before it starts.</summary>
    private const int SegmentsSentAhead = 400;

    private const int Window = 256;

    /// <summary>Exchanges for each segment while a path is streamed: a poll is sent for every 28 segments, position errors are read ten times
    /// and a heartbeat is sent five times a second.</summary>
    public const double ExchangesPerSegment = 1.08;

    /// <summary>Average time of a segment over any window, seconds: 1.6 ms for the exchange and 0.5 ms in which the controller executes the command
    /// (galil-dmc.md A.4).</summary>
    public const double SecondsPerSegment = ExchangesPerSegment * 0.0021;

    /// <summary>A sequence of this many segments is sent while it is cut.</summary>
    public static bool IsNeeded(int segments) => segments > SegmentsSentAhead;

    /// <summary>The highest even speed on each segment at which every window of segments takes long enough, counts/s: the length of the window around it,
    /// divided by that time.</summary>
    /// <param name="lengths">Of the segments, counts.</param>
    /// <param name="secondsPerSegment">Average time of a segment.</param>
    /// <returns>Null where the host is fast enough for any speed.</returns>
    public static int[]? Of(IReadOnlyList<double> lengths, double secondsPerSegment = SecondsPerSegment)
    {
        if (!IsNeeded(lengths.Count)) return null;
        var (speeds, window, from, to) = (new int[lengths.Count], 0.0, 0, 0);
        for (var i = 0; i < speeds.Length; i++)
        {
            var first = Math.Clamp(i - (Window / 2), 0, lengths.Count - Window);
            for (; to < first + Window; to++) window += lengths[to];
            for (; from < first; from++) window -= lengths[from];
            speeds[i] = (int)Math.Clamp(2.0 * Math.Floor(window / (Window * secondsPerSegment) / 2.0), DmcLimits.SlowestSpeed, DmcLimits.FastestSpeed);
        }

        return speeds;
    }

    /// <summary>The factor by which the planned speeds of a sequence may be raised; 1 at least.</summary>
    /// <param name="secondsPerSegment">As for <see cref="Of"/>.</param>
    public static double Headroom(IReadOnlyList<double> lengths, int speed, double secondsPerSegment) => Of(lengths, secondsPerSegment) is { } most ? Math.Max(1.0, most.Min() / (double)speed) : double.PositiveInfinity;
}
