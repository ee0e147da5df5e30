using Engraver.Core.Geometry;
using Engraver.Core.Sequencing.Chaining;

namespace Engraver.Core.Sequencing.Ordering;

/// <summary>Finds the entity that is cut in place of a requested entity, when it was removed as a duplicate or replaced by a recovered arc.</summary>
internal static class EntrySubstitute
{
    /// <summary>The request itself, unless it names an entity that should be cut but is no longer in the table.</summary>
    public static EntryRequest Resolve(EntryRequest requested, ChainedTable chained)
    {
        if (requested is not EntryRequest.AtEntity { EntityIndex: var entity } || RowOf(entity, chained.Kept) >= 0) return requested;
        var drawn = RowOf(entity, chained.Analysed);
        return drawn < 0 || chained.Kept.Count == 0 ? requested : new EntryRequest.AtEntity(Nearest(chained.Analysed[drawn].ToSegment(), chained));
    }

    private static int RowOf(int entity, EntityTables.EntityTable table)
    {
        for (var row = 0; row < table.Count; row++)
        {
            if (table.EntityIndexOf(row) == entity) return row;
        }

        return -1;
    }

    /// <summary>A substitute coincides with the whole segment, so ends and middle together identify it even where other contours cross.</summary>
    private static int Nearest(Segment drawn, ChainedTable chained)
    {
        var (nearest, least) = (0, double.PositiveInfinity);
        var segments = chained.Segments.Span;
        for (var row = 0; row < segments.Length; row++)
        {
            var off = segments[row].DistanceTo(drawn.Start) + segments[row].DistanceTo(drawn.PointAt(0.5)) + segments[row].DistanceTo(drawn.End);
            if (off < least) (nearest, least) = (row, off);
        }

        return chained.Kept.EntityIndexOf(nearest);
    }
}
