using Engraver.Core.Geometry;
using Engraver.Core.Offsets.Graphs;

namespace Engraver.Core.Offsets;

/// <summary>Converts a run of edges to segments.</summary>
internal static class LoopBuilder
{
    /// <summary>A closed loop, moved; no segment begins within a raw piece.</summary>
    public static OffsetLoop Closed(RawGraph graph, IReadOnlyList<int> edges, Vector2D by) => Built(graph, closed: true, JoinedEdges.Closed(graph.Pieces, edges), by);

    /// <summary>Edges that follow each other, moved.</summary>
    public static OffsetLoop Open(RawGraph graph, IReadOnlyList<int> edges, Vector2D by) => Built(graph, closed: false, JoinedEdges.Open(graph.Pieces, edges), by);

    private static OffsetLoop Built(RawGraph graph, bool closed, List<GraphEdge> parts, Vector2D by) =>
        new([.. parts.Select(part => graph.Pieces.PieceOf(part).Moved(by).ToSegment())], closed) { Sources = [.. parts.Select(part => graph.SourceOf(part))] };
}
