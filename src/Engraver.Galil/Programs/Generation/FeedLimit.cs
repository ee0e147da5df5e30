using Engraver.Core.Machines;
using Engraver.Galil.Language;

namespace Engraver.Galil.Programs.Generation;

/// <summary>The speed at which the host can still send a long sequence: a segment needs about 1.6 ms (galil-dmc.md B.7), and a buffer that runs dry stops the
/// machine at once.</summary>
internal static class FeedLimit
{
    /// <summary>A sequence of up to this many segments is in the buffer before it starts.</summary>
    private const int SegmentsSentAhead = 400;

    private const int Window = 256;

    /// <summary>Average time of a segment over any window, seconds.</summary>
    private const double SecondsPerSegment = 0.0025;

    /// <summary>The desired speed, or the highest even one at which every window of segments takes long enough (counts/s).</summary>
    public static int For(IReadOnlyList<VectorSegment> segments, int wanted)
    {
        if (segments.Count <= SegmentsSentAhead) return wanted;
        var fastest = ShortestWindow(segments) / (Window * SecondsPerSegment);
        return fastest >= wanted ? wanted : Math.Max(DmcLimits.SlowestSpeed, 2 * (int)(fastest / 2.0));
    }

    private static double ShortestWindow(IReadOnlyList<VectorSegment> segments)
    {
        var length = 0.0;
        for (var i = 0; i < Window; i++) length += segments[i].Length;
        var shortest = length;
        for (var i = Window; i < segments.Count; i++)
        {
            length += segments[i].Length - segments[i - Window].Length;
            shortest = Math.Min(shortest, length);
        }

        return shortest;
    }
}
