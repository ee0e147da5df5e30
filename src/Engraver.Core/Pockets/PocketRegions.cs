using Engraver.Core.Geometry;
using Engraver.Core.Geometry.Biarcs;
using Engraver.Core.Offsets;
using Engraver.Core.Offsets.Pieces;
using Engraver.Core.Sequencing.Nesting;

namespace Engraver.Core.Pockets;

/// <summary>An outer contour and the islands directly in it.</summary>
/// <param name="Contours">Contours as drawn, the outer one first.</param>
/// <param name="Inset">Distance of these inside the drawn contours: 0, or almost 0 where drawn contours cross.</param>
/// <param name="Walls">The same as lines and arcs, with the material on the left.</param>
internal sealed record PocketRegion(IReadOnlyList<OffsetContour> Contours, double Inset, IReadOnlyList<PathPiece[]> Walls)
{
    /// <summary>Area, mm2.</summary>
    public double Area => Walls.Sum(wall => ChainArea.Of([.. wall.Select(piece => piece.ToSegment())]));
}

/// <summary>Converts closed contours to regions by nesting: the area inside an odd number of them.</summary>
internal static class PocketRegions
{
    /// <summary>Millimetres by which contours that cross or touch are moved inwards to separate them; the smallest distance at which the offset
    /// closes.</summary>
    private static readonly double[] s_insets = [1e-7, 1e-6, 1e-5, 1e-4, 1e-3];

    private const double Tolerance = 1e-10;

    /// <summary>Ends that are rounded differently are joined even when the join tolerance is 0, millimetres.</summary>
    private const double EndRounding = 1e-6;

    /// <summary>The regions in the order of their outer contours, and the points where crossing contours could not be separated.</summary>
    /// <param name="joinTolerance">Distance within which drawn ends were joined, millimetres.</param>
    public static (List<PocketRegion> Regions, IReadOnlyList<Point2D> Unresolved) Of(IReadOnlyList<OffsetContour> contours, OffsetOptions options, double joinTolerance)
    {
        List<OffsetContour> closed = [.. contours.Where(contour => contour.Closed && contour.Segments.Any(segment => segment.Length > 0.0))];
        if (closed.Count == 0) return ([], []);
        if (!TouchEachOther(closed, options, Math.Max(joinTolerance, EndRounding))) return (Split(closed, 0.0, options), []);
        var (inset, parted) = (0.0, default(OffsetResult));
        foreach (var by in s_insets)
        {
            (inset, parted) = (by, ContourOffset.Offset(closed, by, OffsetSide.In, options));
            if (parted.Unresolved.Count == 0) break;
        }

        return (Split([.. parted!.Loops.Select(loop => new OffsetContour(loop.Segments, true))], inset, options), parted.Unresolved);
    }

    /// <summary>True when any two pieces have a common point other than the joint of neighbours. True in case of doubt, which only causes the inset.</summary>
    private static bool TouchEachOther(List<OffsetContour> closed, OffsetOptions options, double joint)
    {
        PathPiece[][] walls = [.. closed.Select(contour => Pieces(Arcs(contour, options)))];
        PathPiece[] pieces = [.. walls.SelectMany(wall => wall)];
        int[] wallOf = [.. walls.SelectMany((wall, index) => Enumerable.Repeat(index, wall.Length))];
        Span<Crossing> found = stackalloc Crossing[PieceCrossings.MaxCount];
        foreach (var (first, second) in new PieceTree(pieces).Pairs(Tolerance))
        {
            var (a, b) = (pieces[first], pieces[second]);
            var count = PieceCrossings.Between(a, b, Tolerance, found);
            var areNeighbours = wallOf[first] == wallOf[second] && (a.End.IsNear(b.Start, joint) || b.End.IsNear(a.Start, joint));
            for (var i = 0; i < count; i++)
            {
                var place = found[i].Place;
                if (!areNeighbours || !(place.IsNear(a.End, joint) || place.IsNear(a.Start, joint))) return true;
            }
        }

        return walls.Any(wall => wall.Length == 2 && wall[0].At(0.5).IsNear(wall[1].At(0.5), joint));
    }

    private static Segment[] Arcs(OffsetContour contour, OffsetOptions options) => [.. contour.Segments.SelectMany(segment => segment.IsFreeCurve ? BiarcFit.Fit(segment.Curve, options.MaxErrorMm) : [segment])];

    private static PathPiece[] Pieces(Segment[] segments) => [.. segments.Where(segment => segment.Length > 0.0).Select(segment => PathPiece.FromSegment(segment))];

    private static List<PocketRegion> Split(List<OffsetContour> closed, double inset, OffsetOptions options)
    {
        Segment[][] arcs = [.. closed.Select(contour => Arcs(contour, options))];
        ContourRegion[] insides = [.. arcs.Select(segments => new ContourRegion(segments))];
        var around = Around(arcs, insides);
        var islands = Enumerable.Range(0, closed.Count).Where(hole => around[hole].Count % 2 == 1).ToLookup(hole => around[hole].Where(outer => around[outer].Count == around[hole].Count - 1).DefaultIfEmpty(-1).First());
        var regions = new List<PocketRegion>();
        for (var outer = 0; outer < closed.Count; outer++)
        {
            if (around[outer].Count % 2 != 0) continue;
            int[] members = [outer, .. islands[outer]];
            regions.Add(new PocketRegion([.. members.Select(member => closed[member])], inset, [.. members.Select(member => Wall(arcs[member], member == members[0]))]));
        }

        return regions;
    }

    /// <summary>For each contour, the contours that contain it.</summary>
    private static List<int>[] Around(Segment[][] arcs, ContourRegion[] insides)
    {
        var tree = BoxTree.Build([.. insides.Select(inside => inside.Bounds)]);
        var around = new List<int>[arcs.Length];
        for (var i = 0; i < arcs.Length; i++)
        {
            around[i] = [];
            tree.Containing(insides[i].Bounds, around[i]);
            var (own, place) = (i, arcs[i][0].PointAt(0.5));
            around[i].RemoveAll(other => other == own || !insides[other].Contains(place));
        }

        return around;
    }

    /// <summary>Outer contours counter-clockwise, islands clockwise.</summary>
    private static PathPiece[] Wall(Segment[] segments, bool isOuter)
    {
        var pieces = Pieces(segments);
        if (ChainArea.Of(segments) > 0.0 == isOuter) return pieces;
        Array.Reverse(pieces);
        return [.. pieces.Select(piece => piece.Reversed())];
    }
}
