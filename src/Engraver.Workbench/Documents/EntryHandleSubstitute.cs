using Engraver.Core.Drawings;
using Engraver.Core.Geometry;

namespace Engraver.Workbench.Documents;

/// <summary>Finds the object that replaces one that was joined, exploded or erased as a duplicate.</summary>
internal static class EntryHandleSubstitute
{
    /// <param name="candidates">Candidate objects of the edited drawing.</param>
    /// <returns>The handle of the one that coincides with the lost object; null if there is none.</returns>
    public static string? HandleOf(Drawing before, string lost, Drawing after, IEnumerable<int> candidates)
    {
        if (before.IndexOfHandle(lost) is not { } index) return null;
        var drawn = SegmentsOf(before, index)[0];
        var (best, least) = (-1, double.PositiveInfinity);
        foreach (var candidate in candidates)
        {
            var off = SegmentsOf(after, candidate).Min(segment => OffAlong(segment, drawn));
            if (off < least) (best, least) = (candidate, off);
        }

        return best < 0 ? null : after.SourceOf(best).Handle;
    }

    private static double OffAlong(Segment segment, Segment drawn) => segment.DistanceTo(drawn.PointAt(0.0)) + segment.DistanceTo(drawn.PointAt(0.5)) + segment.DistanceTo(drawn.PointAt(1.0));

    private static List<Segment> SegmentsOf(Drawing drawing, int index) => [.. DrawingRebuild.PartsOf(drawing, index).Select(part => drawing.SegmentOf(part))];
}
