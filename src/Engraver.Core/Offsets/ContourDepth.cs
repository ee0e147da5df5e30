using Engraver.Core.Geometry;
using Engraver.Core.Offsets.Pieces;
using Engraver.Core.Sequencing.Nesting;

namespace Engraver.Core.Offsets;

/// <summary>Closed contours as the boundary of material: the area inside an odd number of them.</summary>
internal static class ContourDepth
{
    /// <summary>The contours with their material on the left: outer ones counter-clockwise, holes clockwise. Only for contours that neither cross nor
    /// touch.</summary>
    public static List<SourceChain> WithMaterialOnLeft(IReadOnlyList<SourceChain> closed)
    {
        var regions = new ContourRegion[closed.Count];
        for (var i = 0; i < regions.Length; i++) regions[i] = RegionOf([closed[i]]);
        var tree = BoxTree.Build([.. regions.Select(region => region.Bounds)]);
        var around = new List<int>();
        var oriented = new List<SourceChain>(closed.Count);
        for (var i = 0; i < regions.Length; i++)
        {
            around.Clear();
            tree.Containing(regions[i].Bounds, around);
            var depth = around.Count(other => other != i && regions[other].Contains(closed[i].Pieces[0].Start));
            var isCounterClockwise = regions[i].SignedArea > 0.0;
            oriented.Add(isCounterClockwise == ((depth & 1) == 0) ? closed[i] : closed[i].Reversed());
        }

        return oriented;
    }

    /// <summary>The area inside an odd number of contours, including contours that cross.</summary>
    public static ContourRegion RegionOf(IEnumerable<SourceChain> closed) => new([.. closed.SelectMany(chain => chain.Pieces).Select(piece => piece.ToSegment())]);

    /// <summary>True when any two pieces have a common point other than the joint of neighbours on a contour.</summary>
    /// <param name="tree">Tree of the pieces of all contours, in sequence.</param>
    /// <param name="closed">The contours.</param>
    /// <param name="tolerance">Distance that counts as zero.</param>
    public static bool TouchEachOther(PieceTree tree, IReadOnlyList<SourceChain> closed, double tolerance)
    {
        if (closed.Any(chain => IsThereAndBack(chain, tolerance))) return true;
        var next = Successors(closed, tree.Pieces.Count);
        Span<Crossing> found = stackalloc Crossing[PieceCrossings.MaxCount];
        foreach (var (first, second) in tree.Pairs(tolerance))
        {
            var (a, b) = (tree.Pieces[first], tree.Pieces[second]);
            var count = PieceCrossings.Between(a, b, tolerance, found);
            for (var i = 0; i < count; i++)
            {
                if (!IsJoint(a, b, next[first] == second, found[i]) && !IsJoint(b, a, next[second] == first, found[i] with { OnFirst = found[i].OnSecond, OnSecond = found[i].OnFirst })) return true;
            }
        }

        return false;
    }

    /// <summary>Two pieces that cover each other from end to end meet only at their joints and enclose no area.</summary>
    public static bool IsThereAndBack(SourceChain chain, double tolerance) =>
        chain.Pieces.Length == 2 && chain.Pieces[0].At(0.5).IsNear(chain.Pieces[1].At(0.5), tolerance);

    private static int[] Successors(IReadOnlyList<SourceChain> closed, int count)
    {
        var next = new int[count];
        var first = 0;
        foreach (var chain in closed)
        {
            for (var i = 0; i < chain.Pieces.Length; i++) next[first + i] = first + ((i + 1) % chain.Pieces.Length);
            first += chain.Pieces.Length;
        }

        return next;
    }

    /// <summary>The point at which neighbours meet; where they are almost tangent, the computed point can be slightly away from it.</summary>
    private static bool IsJoint(in PathPiece before, in PathPiece after, bool areNeighbours, in Crossing found)
    {
        if (!areNeighbours) return false;
        if (found is { OnFirst: 1.0, OnSecond: 0.0 }) return true;
        return PieceCrossings.JointError(before.EndTangent, after.StartTangent, Math.Max(before.Radius, after.Radius)) is { } error && found.Place.IsNear(before.End, error);
    }
}
