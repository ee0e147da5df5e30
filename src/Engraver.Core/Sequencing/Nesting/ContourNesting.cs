using Engraver.Core.Geometry;
using Engraver.Core.Sequencing.Chaining;

namespace Engraver.Core.Sequencing.Nesting;

/// <summary>Finds the closed contour that directly encloses each contour. The order of cutting depends on it: an inner contour is cut before the contour that
/// holds its material.</summary>
public static class ContourNesting
{
    private const int Witnesses = 5;

    /// <summary>For each contour the index of the closed contour that directly encloses it, -1 for none. Cycles cannot occur.</summary>
    /// <param name="contours">Open and closed contours.</param>
    /// <param name="segments">Rows of the contours by index.</param>
    /// <param name="tolerance">Millimetres by which a contour may extend beyond the box of the enclosing contour (when it touches from inside).</param>
    /// <remarks>A contour is inside when most of five points spread over it are (arcs are exact). The same majority decides for contours that cross each
    /// other.</remarks>
    public static int[] Find(IReadOnlyList<Contour> contours, ReadOnlyMemory<Segment> segments, double tolerance)
    {
        var outlines = new ContourOutline[contours.Count];
        for (var i = 0; i < outlines.Length; i++) outlines[i] = new ContourOutline(contours[i], segments);
        int[] closed = [.. Enumerable.Range(0, outlines.Length).Where(i => outlines[i].IsClosed)]; // thousands of long lines of a drawing can be in each other's boxes
        var tree = BoxTree.Build([.. closed.Select(i => outlines[i].Bounds.Grown(tolerance))]);
        var inside = new int[outlines.Length];
        var candidates = new List<int>();
        for (var i = 0; i < inside.Length; i++)
        {
            candidates.Clear();
            tree.Containing(outlines[i].Bounds, candidates); // not those around one point: all contours of a star meet at its centre
            for (var at = 0; at < candidates.Count; at++) candidates[at] = closed[candidates[at]];
            inside[i] = DirectlyAround(i, outlines, candidates, tolerance);
        }

        return inside;
    }

    private static int DirectlyAround(int inner, ContourOutline[] outlines, List<int> candidates, double tolerance)
    {
        candidates.RemoveAll(outer => outer == inner || !outlines[outer].CanEnclose(outlines[inner], tolerance)); // each is in its own box: its size need not be compared with itself
        while (candidates.Count > 0)
        {
            var smallest = SmallestOf(candidates, outlines); // almost always the result, so that sorting concentric rings is unnecessary
            var outer = candidates[smallest];
            if (HoldsMost(outlines[outer].Region, outlines[inner])) return outer;
            candidates[smallest] = candidates[^1];
            candidates.RemoveAt(candidates.Count - 1);
        }

        return -1;
    }

    private static int SmallestOf(List<int> candidates, ContourOutline[] outlines)
    {
        var smallest = 0;
        for (var i = 1; i < candidates.Count; i++)
        {
            var order = outlines[candidates[i]].CompareSize(outlines[candidates[smallest]]);
            if (order < 0 || (order == 0 && candidates[i] < candidates[smallest])) smallest = i;
        }

        return smallest;
    }

    private static bool HoldsMost(ContourRegion region, ContourOutline inner)
    {
        var held = 0;
        for (var i = 0; i < Witnesses; i++)
        {
            if (region.Contains(inner.Witness(i, Witnesses))) held++;
            if (held > Witnesses / 2) return true;
        }

        return false;
    }
}
