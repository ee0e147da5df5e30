using Engraver.Core.Geometry;

namespace Engraver.Core.Unions;

/// <summary>Groups of contours whose boxes overlap, directly or through others: contours of different groups do not affect each other.</summary>
internal static class OverlappingGroups
{
    /// <summary>The groups in the order of their first contours.</summary>
    /// <param name="contours">The contours, none empty.</param>
    /// <param name="tolerance">Distance of boxes that counts as overlapping.</param>
    public static IEnumerable<IReadOnlyList<IReadOnlyList<Segment>>> Find(IReadOnlyList<IReadOnlyList<Segment>> contours, double tolerance)
    {
        var boxes = new Bounds2D[contours.Count];
        for (var i = 0; i < boxes.Length; i++)
        {
            boxes[i] = Bounds2D.Empty;
            foreach (var segment in contours[i]) boxes[i] = boxes[i].Union(segment.Bounds).Including(segment.Start).Including(segment.End);
            boxes[i] = boxes[i].Grown(tolerance);
        }

        var tree = BoxTree.Build(boxes);
        var (first, found) = (new int[boxes.Length], new List<int>());
        for (var i = 0; i < first.Length; i++) first[i] = i;
        for (var i = 0; i < first.Length; i++)
        {
            found.Clear();
            tree.Overlapping(boxes[i], found);
            foreach (var other in found) Join(first, i, other);
        }

        return Enumerable.Range(0, first.Length).GroupBy(i => FirstOf(first, i), i => contours[i]).Select(group => group.ToArray());
    }

    private static void Join(int[] first, int one, int other)
    {
        (one, other) = (FirstOf(first, one), FirstOf(first, other));
        first[Math.Max(one, other)] = Math.Min(one, other);
    }

    private static int FirstOf(int[] first, int contour)
    {
        while (first[contour] != contour) contour = first[contour] = first[first[contour]];
        return contour;
    }
}
