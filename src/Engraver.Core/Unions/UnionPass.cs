using Engraver.Core.Geometry;
using Engraver.Core.Offsets;
using Engraver.Core.Offsets.Graphs;
using Engraver.Core.Offsets.Pieces;

namespace Engraver.Core.Unions;

/// <summary>One computation from overlapping contours to the outlines of their union.</summary>
internal sealed class UnionPass
{
    /// <summary>Tolerances to try, as multiples. Where contours almost coincide over a long way, a crossing can be evaluated in two ways, and another tolerance
    /// avoids this.</summary>
    private static readonly double[] Attempts = [1.0, 0.1, 10.0, 100.0];

    /// <summary>Width below which an outline is ignored, in tolerances.</summary>
    private const double SliverTolerances = 8.0;

    private readonly IReadOnlyList<IReadOnlyList<Segment>> _contours;
    private readonly List<SourceChain> _chains = [];
    private readonly List<(int Contour, int Segment, int Count)> _sources = [];
    private readonly PieceGraph _graph;

    private UnionPass(IReadOnlyList<IReadOnlyList<Segment>> contours, double tolerance)
    {
        _contours = contours;
        for (var i = 0; i < contours.Count; i++) Add(i, tolerance);
        var (ends, nodes) = (new List<(int Start, int End)>(), new List<Point2D>());
        foreach (var chain in _chains)
        {
            var first = nodes.Count;
            for (var i = 0; i < chain.Pieces.Length; i++) ends.Add((first + i, first + ((i + 1) % chain.Pieces.Length)));
            nodes.AddRange(chain.Pieces.Select(piece => piece.Start));
        }

        var tree = new PieceTree([.. _chains.SelectMany(chain => chain.Pieces)]);
        _graph = PieceGraph.From(tree, [.. ends], new NodeMerger(nodes, [], PieceGraph.NodeTolerances * tolerance), tolerance, PieceContact.CrossingsAndEnds);
        var loops = new UnionBoundary(_graph, tree, new WindingNumbers(_chains)).Loops();
        Result = new UnionResult([.. loops.Loops().Select(Outline).OfType<IReadOnlyList<Segment>>()], [.. loops.Unbalanced.Select(_graph.PlaceOf)]);
    }

    private UnionResult Result { get; }

    /// <param name="contours">Closed contours.</param>
    /// <param name="tolerance">Distance that counts as zero.</param>
    /// <returns>The contours as given when no tolerance gives closed outlines.</returns>
    public static UnionResult Run(IReadOnlyList<IReadOnlyList<Segment>> contours, double tolerance)
    {
        var rounding = PieceRounding.Of(Extent(contours), contours.SelectMany(contour => contour));
        var unresolved = default(IReadOnlyList<Point2D>);
        foreach (var attempt in Attempts)
        {
            var pass = new UnionPass(contours, Math.Max(rounding, attempt * tolerance));
            if (pass.Result.IsComplete) return pass.Result;
            unresolved ??= pass.Result.Unresolved;
        }

        return new UnionResult(contours, unresolved!);
    }

    private static double Extent(IReadOnlyList<IReadOnlyList<Segment>> contours) =>
        contours.Max(contour => contour.Max(segment => Math.Max(Math.Abs(segment.Start.X) + Math.Abs(segment.Start.Y), Math.Abs(segment.End.X) + Math.Abs(segment.End.Y))));

    private void Add(int contour, double tolerance)
    {
        var chain = SourceChain.From(new OffsetContour(_contours[contour], Closed: true), contour, OffsetOptions.Round(tolerance), tolerance);
        if (chain is null || ContourDepth.IsThereAndBack(chain, tolerance)) return;
        _chains.Add(chain);
        foreach (var source in chain.Sources) _sources.Add((contour, source.Segment, chain.Pieces.Length));
    }

    /// <summary>Null for an outline without width.</summary>
    private IReadOnlyList<Segment>? Outline(List<int> loop)
    {
        var first = _graph.Edges[loop[0]];
        var (contour, _, count) = _sources[first.Piece];
        if (loop.Count == count && loop.TrueForAll(edge => IsWhole(_graph.Edges[edge]) && _graph.Edges[edge].From == first.From && _sources[_graph.Edges[edge].Piece].Contour == contour))
        {
            return first.From == 0.0 ? _contours[contour] : [.. _contours[contour].Reverse().Select(segment => segment.Reversed())];
        }

        List<Segment> outline = [.. JoinedEdges.Closed(_graph, loop).Select(SegmentOf)];
        return Math.Abs(ChainArea.Of(outline)) > SliverTolerances * _graph.Tolerance * outline.Sum(segment => segment.Length) ? outline : null;
    }

    private static bool IsWhole(in GraphEdge edge) => Math.Abs(edge.To - edge.From) == 1.0;

    /// <summary>The given segment where it is part of the outline from end to end.</summary>
    private Segment SegmentOf(GraphEdge part)
    {
        var piece = _graph.PieceOf(part);
        if (IsWhole(part))
        {
            var source = _contours[_sources[part.Piece].Contour][_sources[part.Piece].Segment];
            var given = part.From == 0.0 ? source : source.Reversed();
            if (given.Start == piece.Start && given.End == piece.End) return given;
        }

        return piece.ToSegment();
    }
}
