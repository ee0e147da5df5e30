using Engraver.Core.Geometry;

namespace Engraver.Core.Drawings;

/// <summary>Finds visible curves of a drawing by position; hidden curves, and those on a layer that is off or frozen, are not found. Drawing units, plan
/// view.</summary>
public static class DrawingPick
{
    /// <summary>Every visible curve, in drawing order.</summary>
    public static IEnumerable<int> Visible(Drawing drawing) => Enumerable.Range(0, drawing.Entities.Count).Where(entity => IsVisible(drawing, entity));

    /// <summary>Curves that are completely in the box (a window selection).</summary>
    public static IEnumerable<int> Inside(Drawing drawing, Bounds2D box) => Visible(drawing).Where(entity => drawing.Entities[entity].PartCount > 0 && Segments(drawing, entity).All(segment => box.Contains(segment.Bounds)));

    /// <summary>Curves with at least one point in the box (a crossing selection).</summary>
    public static IEnumerable<int> Touching(Drawing drawing, Bounds2D box) => Visible(drawing).Where(entity => Segments(drawing, entity).Any(segment => box.Touches(segment)));

    /// <summary>The nearest curve no farther away than <paramref name="within"/>, ties to the one that was drawn last; null when there is none.</summary>
    public static int? Nearest(Drawing drawing, Point2D place, double within)
    {
        int? best = null;
        foreach (var entity in Visible(drawing))
        {
            var distance = Segments(drawing, entity).Select(segment => segment.DistanceTo(place)).DefaultIfEmpty(double.PositiveInfinity).Min();
            if (!(distance <= within)) continue;
            (best, within) = (entity, distance);
        }

        return best;
    }

    /// <summary>The parts of a curve in plan, in order.</summary>
    public static IEnumerable<Segment> Segments(Drawing drawing, int entity)
    {
        var first = drawing.Entities[entity].FirstPart;
        return Enumerable.Range(first, drawing.Entities[entity].PartCount).Select(part => drawing.SegmentOf(drawing.Parts[part]));
    }

    /// <summary>Smallest box of the given curves; empty for none.</summary>
    public static Bounds2D BoundsOf(Drawing drawing, IEnumerable<int> entities) =>
        entities.SelectMany(entity => Segments(drawing, entity)).Aggregate(Bounds2D.Empty, (box, segment) => box.Union(segment.Bounds));

    private static bool IsVisible(Drawing drawing, int entity) =>
        !drawing.Entities[entity].Hidden && drawing.Layers[drawing.Entities[entity].Layer] is { On: true, Frozen: false };
}
