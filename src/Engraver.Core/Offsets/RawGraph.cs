using Engraver.Core.Offsets.Graphs;
using Engraver.Core.Offsets.Pieces;

namespace Engraver.Core.Offsets;

/// <summary>The raw offset cut at every point where it crosses itself.</summary>
/// <remarks>Two edges that coincide in opposite directions cancel: there is no free area between them (walls exactly two distances apart). Two edges in the
/// same direction count as one.</remarks>
internal sealed class RawGraph
{
    private readonly IReadOnlyList<RawPiece> _raw;
    private readonly RawSides[] _sides;
    private readonly bool[] _gone;

    private RawGraph(RawOffset raw, CoveredEnds ends)
    {
        _raw = ends.Pieces;
        var nodes = new NodeMerger(ends.Nodes, raw.Same, PieceGraph.NodeTolerances * raw.Tolerance);
        Pieces = PieceGraph.From(new PieceTree([.. _raw.Select(raw => raw.Piece)]), [.. _raw.Select(raw => (raw.Start, raw.End))], nodes, raw.Tolerance, PieceContact.Crossings);
        (_sides, _gone) = (new RawSides[Pieces.Edges.Count], new bool[Pieces.Edges.Count]);
        for (var edge = 0; edge < _gone.Length; edge++)
        {
            var leader = Pieces.LeaderOf(edge);
            _sides[edge] |= _raw[Pieces.Edges[edge].Piece].Side;
            if (leader == edge) continue;
            _gone[edge] = true;
            _sides[leader] |= _sides[edge];
            _gone[leader] |= Pieces.AreOpposite(leader, edge);
        }
    }

    /// <summary>Nodes and edges.</summary>
    public PieceGraph Pieces { get; }

    /// <param name="raw">The raw offset.</param>
    /// <param name="source">The drawn segments, when all points nearer to them than the distance are covered; null when corners have another shape.</param>
    public static RawGraph From(RawOffset raw, PieceTree? source) => new(raw, CoveredEnds.TakenFrom(raw, source));

    /// <summary>True for an edge that coincides with another and is not counted.</summary>
    public bool IsGone(int edge) => _gone[edge];

    /// <summary>The source of an edge.</summary>
    public OffsetSource SourceOf(in GraphEdge edge) => _raw[edge.Piece].Source;

    /// <summary>The sides of all edges that coincide with it in its direction.</summary>
    public RawSides SidesOf(int edge) => _sides[edge];
}
