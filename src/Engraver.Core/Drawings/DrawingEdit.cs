using Engraver.Core.Geometry;

namespace Engraver.Core.Drawings;

/// <summary>Changes to a drawing. Each returns a new drawing and leaves the old one unchanged; the balance and the findings of the import are kept, because
/// they describe the file.</summary>
/// <remarks>Entities are named by their index in <see cref="Drawing.Entities"/>; an index given twice counts once.</remarks>
public static class DrawingEdit
{
    /// <summary>The drawing without the given entities. The others keep their order and get new indices.</summary>
    public static Drawing Erase(Drawing drawing, IEnumerable<int> entities)
    {
        var erased = entities.ToHashSet();
        var kept = new GrowingColumn<DrawingEntity>();
        var parts = new GrowingColumn<DrawingPart>();
        for (var index = 0; index < drawing.Entities.Count; index++)
        {
            if (erased.Contains(index)) continue;
            var entity = drawing.Entities[index];
            AppendParts(drawing, entity, kept.Count, parts);
            entity.FirstPart = parts.Count - entity.PartCount;
            kept.Add(entity);
        }

        return drawing with { Entities = kept, Parts = parts, Inserts = new EditedInserts(drawing, erased.Where(index => index < drawing.Entities.Count)).Erased() };
    }

    /// <summary>Moves, rotates, scales or mirrors the given entities.</summary>
    /// <returns>False when a coordinate would leave the range of a drawing or a radius would become 0; then the drawing is unchanged.</returns>
    public static bool TryTransform(Drawing drawing, IEnumerable<int> entities, Transform2D map, out Drawing edited)
    {
        var curves = new EditedCurves(drawing);
        IReadOnlyList<int> moved = [.. entities.Distinct()];
        var changes = moved.SelectMany(index => Parts(drawing, index)).Select(part => (part, curves.Transformed(drawing.Parts[part], map))).ToList();
        edited = drawing;
        if (!changes.TrueForAll(change => change.Item2.InRange) || !curves.AreInRange) return false;
        var styles = new EditedStyles(drawing, map.Scale);
        List<(int, DrawingEntity)> widened = [.. moved.Select(index => (index, drawing.Entities[index] with { LineStyle = styles.Scaled(drawing.Entities[index].LineStyle) })).Where(change => change.Item2.LineStyle != drawing.Entities[change.index].LineStyle)];
        var rows = widened.Count == 0 ? drawing.Entities : drawing.Entities.With(widened, []);
        edited = drawing with { Entities = rows, Parts = drawing.Parts.With(changes, []), LineStyles = styles.ToList(), Curves = curves.ToColumn(), Inserts = new EditedInserts(drawing, moved).Moved(map) };
        return true;
    }

    /// <summary>Adds a transformed copy of the given entities after the last one, in their order, with new handles (after the highest of the
    /// drawing).</summary>
    /// <returns>False as for <see cref="TryTransform"/>.</returns>
    public static bool TryCopy(Drawing drawing, IEnumerable<int> entities, Transform2D map, out Drawing edited)
    {
        var copies = new List<DrawingEntity>();
        var parts = new List<DrawingPart>();
        var handle = drawing.HighestHandle();
        var curves = new EditedCurves(drawing);
        var styles = new EditedStyles(drawing, map.Scale);
        IReadOnlyList<int> copied = [.. entities.Distinct()];
        var inserts = new EditedInserts(drawing, copied).Copied(map, out var copyOf);
        foreach (var index in copied)
        {
            var entity = drawing.Entities[index];
            entity.Insert = copyOf(entity.Insert);
            foreach (var part in Parts(drawing, index)) parts.Add(curves.Transformed(drawing.Parts[part], map) with { Entity = drawing.Entities.Count + copies.Count });
            entity.FirstPart = drawing.Parts.Count + parts.Count - entity.PartCount;
            entity.Handle = ++handle;
            entity.LineStyle = styles.Scaled(entity.LineStyle);
            copies.Add(entity);
        }

        edited = drawing;
        if (!parts.TrueForAll(part => part.InRange) || !curves.AreInRange) return false;
        edited = drawing with { Entities = drawing.Entities.With([], copies), Parts = drawing.Parts.With([], parts), LineStyles = styles.ToList(), Curves = curves.ToColumn(), Inserts = inserts };
        return true;
    }

    /// <summary>True when the drawing has inserts without curves, which no edit of curves takes along.</summary>
    public static bool HasFreeInserts(Drawing drawing) => drawing.Inserts.Count > 0 && FreeInserts(drawing).Any();

    /// <summary>Moves the inserts without curves.</summary>
    public static Drawing MoveFreeInserts(Drawing drawing, Transform2D map)
    {
        var free = FreeInserts(drawing).ToHashSet();
        return free.Count == 0 ? drawing : drawing with { Inserts = [.. drawing.Inserts.Select((insert, index) => free.Contains(index) ? insert.Moved(map) : insert)] };
    }

    /// <summary>Adds a copy of each insert without curves for each map.</summary>
    /// <param name="drawing">The drawing to which they are added.</param>
    /// <param name="source">The drawing before the edit.</param>
    public static Drawing CopyFreeInserts(Drawing drawing, Drawing source, IReadOnlyList<Transform2D> maps)
    {
        var free = FreeInserts(source).Select(index => source.Inserts[index]).ToList();
        return free.Count == 0 ? drawing : drawing with { Inserts = [.. drawing.Inserts, .. maps.SelectMany(map => free.Select(insert => insert.Moved(map)))] };
    }

    /// <summary>Erases the inserts without curves.</summary>
    public static Drawing EraseFreeInserts(Drawing drawing)
    {
        var free = FreeInserts(drawing).ToHashSet();
        return free.Count == 0 ? drawing : drawing with { Inserts = [.. drawing.Inserts.Select((insert, index) => free.Contains(index) ? insert with { IsErased = true } : insert)] };
    }

    private static IEnumerable<int> FreeInserts(Drawing drawing)
    {
        var edited = new EditedInserts(drawing, []);
        return Enumerable.Range(0, drawing.Inserts.Count).Where(edited.IsFree);
    }

    /// <summary>Reverses the direction of the given entities; a polyline then begins at its last vertex.</summary>
    public static Drawing Reverse(Drawing drawing, IEnumerable<int> entities)
    {
        var changes = new List<(int, DrawingPart)>();
        var curves = new EditedCurves(drawing);
        foreach (var index in entities.Distinct())
        {
            var parts = Parts(drawing, index);
            changes.AddRange(parts.Zip(parts.Reverse(), (to, from) => (to, curves.Reversed(drawing.Parts[from]))));
        }

        return drawing with { Parts = drawing.Parts.With(changes, []), Curves = curves.ToColumn() };
    }

    private static IEnumerable<int> Parts(Drawing drawing, int index) => Enumerable.Range(drawing.Entities[index].FirstPart, drawing.Entities[index].PartCount);

    private static void AppendParts(Drawing drawing, in DrawingEntity entity, int newIndex, GrowingColumn<DrawingPart> parts)
    {
        for (var part = entity.FirstPart; part < entity.FirstPart + entity.PartCount; part++) parts.Add(drawing.Parts[part] with { Entity = newIndex });
    }
}
