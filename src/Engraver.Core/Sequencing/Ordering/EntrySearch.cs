using Engraver.Core.Geometry;
using Engraver.Core.Sequencing.Chaining;

namespace Engraver.Core.Sequencing.Ordering;

/// <summary>Finds the start of a contour from the entity or point that the operator selected for the entry.</summary>
internal static class EntrySearch
{
    /// <summary>The entry; null when the entity is not cut or there are no contours.</summary>
    public static StrokeEntry? Find(EntryRequest enter, ChainedTable chained, Point2D toolStart) => enter switch
    {
        EntryRequest.AtEntity { EntityIndex: var entity } => AtEntity(entity, chained, toolStart),
        EntryRequest.AtPlace { Place: var place } => Nearest([.. AllEntries(chained), .. OnCircles(chained, place)], place),
        _ => throw new ArgumentOutOfRangeException(nameof(enter)),
    };

    /// <summary>Among the contours with the entity, the start at it that is nearest to the tool; an open contour that has the entity only in the middle is
    /// entered at an end.</summary>
    private static StrokeEntry? AtEntity(int entity, ChainedTable chained, Point2D toolStart)
    {
        var entries = AllEntries(chained).Where(entry => Holds(entry.Contour, entity, chained)).ToList();
        var atEntity = entries.Where(entry => chained.Kept.EntityIndexOf(FirstRow(entry, chained)) == entity).ToList();
        return Nearest(atEntity.Count > 0 ? atEntity : entries, toolStart);
    }

    private static StrokeEntry? Nearest(List<StrokeEntry> entries, Point2D place) =>
        entries.Count == 0 ? null : entries.MinBy(entry => entry.Place.DistanceTo(place));

    private static List<StrokeEntry> AllEntries(ChainedTable chained)
    {
        var entries = new List<StrokeEntry>();
        var contours = chained.Chain.Contours;
        for (var i = 0; i < contours.Count; i++) StrokeEntry.AddAll(i, contours[i], chained.Segments.Span, entries);
        return entries;
    }

    private static IEnumerable<StrokeEntry> OnCircles(ChainedTable chained, Point2D place)
    {
        var contours = chained.Chain.Contours;
        for (var i = 0; i < contours.Count; i++)
        {
            if (StrokeEntry.NearestTo(place, i, contours[i], chained.Segments.Span) is { } entry) yield return entry;
        }
    }

    private static bool Holds(int contour, int entity, ChainedTable chained)
    {
        foreach (var piece in chained.Chain.Contours[contour].Pieces.Span)
        {
            if (chained.Kept.EntityIndexOf(piece.Row) == entity) return true;
        }

        return false;
    }

    private static int FirstRow(StrokeEntry entry, ChainedTable chained) => chained.Chain.Contours[entry.Contour].Pieces.Span[entry.Piece].Row;
}
