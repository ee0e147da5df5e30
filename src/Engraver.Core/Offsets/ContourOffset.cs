using Engraver.Core.Geometry;
using Engraver.Core.Offsets.Pieces;

namespace Engraver.Core.Offsets;

/// <summary>Offsets of contours of lines and arcs that stay lines and arcs (after Liu, Yong, Zheng and Sun 2007, with the result derived from the boundary of
/// the free area).</summary>
/// <remarks>
/// A point belongs to the offset when it is on the raw offset (<see cref="RawOffset"/>) and no drawn segment is nearer to it than the distance. The raw offset
/// is cut at all its crossings (<see cref="RawGraph"/>), each run between crossings is tested at one point (<see cref="OffsetReach"/>), and edges are joined by
/// the numbers of their nodes (<see cref="FreeBoundary"/>), so that every loop is closed.
/// </remarks>
public static class ContourOffset
{
    /// <summary>Length that counts as zero, millimetres; rounding is added to it.</summary>
    private const double MinTolerance = 1e-10;

    /// <summary>Distance from the origin, in sizes of the drawing, beyond which it is computed relative to its centre.</summary>
    private const double OutsideDistance = 100.0;

    /// <summary>Width below which a loop is ignored, in tolerances.</summary>
    private const double SliverTolerances = 8.0;

    /// <param name="contours">The drawn contours.</param>
    /// <param name="distance">Offset distance, millimetres, above 0.</param>
    /// <param name="side">See <see cref="OffsetSide"/>.</param>
    /// <param name="options">Join and tolerances.</param>
    public static OffsetResult Offset(IReadOnlyList<OffsetContour> contours, double distance, OffsetSide side, OffsetOptions options)
    {
        ArgumentOutOfRangeException.ThrowIfNegativeOrZero(distance);
        var (origin, extent) = Place(contours);
        var tolerance = MinTolerance + PieceRounding.Of(extent + distance, contours.SelectMany(contour => contour.Segments));
        List<SourceChain> chains = [.. contours.Select((contour, number) => SourceChain.From(contour, number, options, tolerance)?.Moved(-origin)).OfType<SourceChain>()];
        var work = new OffsetWork(origin, distance, options, tolerance);
        List<SourceChain> closed = [.. chains.Where(chain => chain.Closed)];
        List<SourceChain> open = [.. chains.Where(chain => !chain.Closed)];
        if (side is OffsetSide.In or OffsetSide.Both && closed.Count > 0) work.AddRegion(closed, inside: true);
        if (side is OffsetSide.Out or OffsetSide.Both && closed.Count > 0) work.AddRegion(closed, inside: false);
        if (side is OffsetSide.Left or OffsetSide.Right) foreach (var chain in chains) work.AddSide(chain, side);
        if (side is OffsetSide.Both) foreach (var chain in open) work.AddSide(chain, side);
        var withoutInside = side is OffsetSide.In or OffsetSide.Out ? open.Count : 0;
        return new OffsetResult(work.Loops, OffsetCheck.MaxDeviation(contours, work.Loops, distance, side, options), withoutInside, work.Unresolved);
    }

    /// <summary>Reference point of the computation: the origin, or the centre of a drawing far from it, so that its coordinates lose no digits; and the largest
    /// coordinate relative to it.</summary>
    private static (Vector2D Origin, double Extent) Place(IReadOnlyList<OffsetContour> contours)
    {
        var box = Bounds2D.Empty;
        foreach (var contour in contours)
        {
            foreach (var segment in contour.Segments) box = box.Including(segment.Start).Including(segment.End);
        }

        if (box.IsEmpty) return (default, 0.0);
        var (size, middle) = (box.Width + box.Height, new Vector2D((box.MinX + box.MaxX) / 2.0, (box.MinY + box.MaxY) / 2.0));
        return middle.Length > OutsideDistance * size ? (middle, size) : (default, middle.Length + size);
    }

    /// <summary>The loops found so far.</summary>
    private sealed class OffsetWork(Vector2D origin, double distance, OffsetOptions options, double tolerance)
    {
        public List<OffsetLoop> Loops { get; } = [];

        public List<Point2D> Unresolved { get; } = [];

        /// <summary>Offsets in or out of the material that all closed contours enclose together; of a flat curve clockwise if it is drawn clockwise.</summary>
        public void AddRegion(IReadOnlyList<SourceChain> closed, bool inside, bool clockwise = false)
        {
            var tree = new PieceTree([.. closed.SelectMany(chain => chain.Pieces)]);
            if (ContourDepth.TouchEachOther(tree, closed, tolerance))
            {
                AddCrossing(tree, closed, inside, clockwise);
                return;
            }

            var pass = Run(tree, [.. ContourDepth.WithMaterialOnLeft(closed).Select(chain => inside ? RawChain.LeftOf(chain) : RawChain.RightOf(chain))]);
            foreach (var loop in pass.Loops) AddClosed(pass.Graph, loop, reversed: !inside);
        }

        /// <summary>The left or right side, or both, of a single contour.</summary>
        public void AddSide(SourceChain chain, OffsetSide side)
        {
            if (chain.FlatTurn != 0)
            {
                if (chain.FlatTurn == 1 != (side == OffsetSide.Left)) AddRegion([chain], inside: false, clockwise: chain.FlatTurn < 0);
                return;
            }

            var tree = new PieceTree(chain.Pieces);
            var isSimple = chain.Closed && !ContourDepth.TouchEachOther(tree, [chain], tolerance);
            IReadOnlyList<RawChain> around = !chain.Closed ? [RawChain.Around(chain)] : [RawChain.LeftOf(chain), RawChain.RightOf(chain)];
            var pass = Run(tree, isSimple ? [around[side == OffsetSide.Left ? 0 : 1]] : around);
            foreach (var loop in pass.Loops)
            {
                if (side != OffsetSide.Right) AddOn(pass.Graph, loop, RawSides.Left);
                if (side != OffsetSide.Left) AddOn(pass.Graph, loop, RawSides.Right);
            }
        }

        /// <summary>Contours that cross or touch: offsets both sides of all contours and keeps the loops inside (or outside) the material.</summary>
        private void AddCrossing(PieceTree tree, IReadOnlyList<SourceChain> closed, bool inside, bool clockwise)
        {
            var material = ContourDepth.RegionOf(closed);
            var pass = Run(tree, [.. closed.SelectMany(chain => (RawChain[])[RawChain.LeftOf(chain), RawChain.RightOf(chain)])]);
            foreach (var loop in pass.Loops)
            {
                var longest = loop.MaxBy(pass.Graph.Pieces.LengthOf);
                if (material.Contains(pass.Graph.Pieces.PointOn(longest, 0.5)) == inside) AddClosed(pass.Graph, loop, reversed: !inside && !clockwise);
            }
        }

        private OffsetPass Run(PieceTree tree, IReadOnlyList<RawChain> chains)
        {
            var pass = OffsetPass.Run(tree, chains, distance, options, tolerance);
            Unresolved.AddRange(pass.Unresolved.Select(place => place + origin));
            return pass;
        }

        /// <summary>The part of a loop on one side of the drawn contour: the whole loop, or the parts between the ends of open contours and the segments that
        /// trim it.</summary>
        private void AddOn(RawGraph graph, List<int> loop, RawSides side)
        {
            if (loop.TrueForAll(edge => graph.SidesOf(edge).HasFlag(side)))
            {
                AddClosed(graph, loop, reversed: side == RawSides.Right);
                return;
            }

            var first = loop.FindIndex(edge => !graph.SidesOf(edge).HasFlag(side));
            var part = new List<int>();
            for (var i = 1; i <= loop.Count; i++)
            {
                var edge = loop[(first + i) % loop.Count];
                if (graph.SidesOf(edge).HasFlag(side)) part.Add(edge);
                else if (part.Count > 0)
                {
                    Add(LoopBuilder.Open(graph, part, origin), reversed: side == RawSides.Right);
                    part.Clear();
                }
            }
        }

        private void AddClosed(RawGraph graph, List<int> loop, bool reversed)
        {
            var closed = LoopBuilder.Closed(graph, loop, origin);
            if (Math.Abs(closed.SignedArea) > SliverTolerances * graph.Pieces.Tolerance * closed.Length) Add(closed, reversed);
        }

        private void Add(OffsetLoop loop, bool reversed) =>
            Loops.Add(reversed ? loop with { Segments = [.. loop.Segments.Reverse().Select(segment => segment.Reversed())], Sources = [.. loop.Sources.Reverse()] } : loop);
    }
}
