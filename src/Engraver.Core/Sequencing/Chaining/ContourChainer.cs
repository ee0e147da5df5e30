using Engraver.Core.EntityTables;
using Engraver.Core.Geometry;

namespace Engraver.Core.Sequencing.Chaining;

/// <summary>The paper's AUTOSEQUENCE: loose, arbitrarily directed segments become contours (paper 000, figure 2).</summary>
public static class ContourChainer
{
    /// <summary>Joins segments end to start within <paramref name="joinTolerance"/> (millimetres). Every segment is in exactly one contour.</summary>
    /// <returns>Contours in order of their lowest row, and one discontinuity for each end without a partner. Empty input gives an empty result.</returns>
    /// <remarks>Linear in the number of segments (hash grid of ends); paper 000's repeated passes give the same contours. A contour is extended from its lowest
    /// row forwards, then, when it did not close, backwards. Two ends join when they are within the tolerance of each other (not through a third end). At a
    /// branch: segments shorter than the tolerance first, nearest first (they have no other continuation), then the straightest continuation, then the lowest
    /// row.</remarks>
    public static ChainResult Chain(ReadOnlySpan<Segment> segments, double joinTolerance) => Chain(segments, joinTolerance, EndHeights.Flat);

    /// <summary>The same for segments at different heights: ends at clearly different heights do not join, even when they are near in plan.</summary>
    public static ChainResult Chain(ReadOnlySpan<Segment> segments, double joinTolerance, EndHeights heights)
    {
        var read = segments.ToArray();
        return Chain(read, new SegmentEnds(read, joinTolerance), joinTolerance, heights);
    }

    /// <summary>The same; the segments are read, not copied.</summary>
    /// <param name="ends">Ends of the segments, within the join tolerance. Chaining consumes them.</param>
    /// <param name="isLetter">Rows of letters; null if there are none.</param>
    internal static ChainResult Chain(Segment[] segments, SegmentEnds ends, double joinTolerance, EndHeights heights, Predicate<int>? isLetter = null)
    {
        var walker = new ContourWalker(segments, ends, joinTolerance, heights);
        var contours = walker.WalkAll();
        return new ChainResult(contours, ContourEnds.From(contours, segments, heights, isLetter), walker.Branches) { Comparisons = walker.Comparisons };
    }
}
