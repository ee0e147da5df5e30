using Engraver.Core.Geometry;

namespace Engraver.Core.Sequencing;

/// <summary>Turns the operator's entering entity or place into a way to begin a contour.</summary>
internal static class EntrySearch
{
    /// <summary>Null when the entity is not cut, or when nothing is.</summary>
    public static StrokeEntry? Find(EnterAt enter, ChainedTable chained, Point2D toolStart) => enter switch
    {
        EnterAt.AtEntity { EntityIndex: var entity } => AtEntity(entity, chained, toolStart),
        EnterAt.AtPlace { Place: var place } => Nearest(AllEntries(chained), place),
        _ => throw new ArgumentOutOfRangeException(nameof(enter)),
    };

    /// <summary>Of the contours that hold the entity the start at it that is nearest to the tool; an open contour that has it only in the middle is entered at an end.</summary>
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
