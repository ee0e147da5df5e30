using Engraver.Core.Drawings;
using Engraver.Core.Sequencing.Chaining;

namespace Engraver.Workbench.Documents;

/// <summary>Finds duplicate entities.</summary>
internal static class Duplicates
{
    /// <summary>The entities that can be erased: every part coincides with a part of a remaining entity.</summary>
    /// <param name="tolerance">Drawing units.</param>
    public static IReadOnlyList<int> Find(Drawing drawing, IReadOnlyList<int> indices, double tolerance)
    {
        var owners = new List<int>();
        var segments = new List<Core.Geometry.Segment>();
        foreach (var index in indices.Order())
        {
            foreach (var part in DrawingRebuild.PartsOf(drawing, index))
            {
                owners.Add(index);
                segments.Add(drawing.SegmentOf(part));
            }
        }

        var kept = DuplicateRemoval.Keep(segments.ToArray(), tolerance).Select(row => owners[row]).ToHashSet();
        return [.. indices.Where(index => !kept.Contains(index))];
    }
}
