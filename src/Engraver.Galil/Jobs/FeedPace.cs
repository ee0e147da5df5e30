using Engraver.Galil.Links;
using Engraver.Galil.Programs;

namespace Engraver.Galil.Jobs;

/// <summary>How the segment buffer is fed over this kind of link.</summary>
/// <param name="SegmentsBetweenPolls">Segments between two looks at the counter.</param>
/// <param name="FillsFirst">The buffer is filled before the machine starts, however long the segments are: over a slow wire it cannot be filled later.</param>
/// <param name="ReactionSeconds">What passes between seeing that the lead is short and saying so, seconds.</param>
internal sealed record FeedPace(int SegmentsBetweenPolls, bool FillsFirst, double ReactionSeconds)
{
    /// <summary>1.6 ms a command (galil-dmc.md A.4): two polls and a heartbeat.</summary>
    private static FeedPace Network { get; } = new(16, FillsFirst: false, 0.06);

    public static FeedPace Of(SerialLine? line) => line is null ? Network : new FeedPace(WireFeed.SegmentsBetweenPolls, FillsFirst: true, WireFeed.ReactionSeconds(line));
}
