namespace Engraver.Core.Offsets.Graphs;

/// <summary>Edges that follow each other, with consecutive parts of one piece as one part again.</summary>
internal static class JoinedEdges
{
    /// <summary>The parts of a closed loop; none begins within a piece.</summary>
    public static List<GraphEdge> Closed(PieceGraph graph, IReadOnlyList<int> loop)
    {
        var first = 0;
        while (first < loop.Count && Continues(graph, loop[(first + loop.Count - 1) % loop.Count], loop[first])) first++;
        if (first == loop.Count) first = 0;
        return Open(graph, [.. Enumerable.Range(0, loop.Count).Select(i => loop[(first + i) % loop.Count])]);
    }

    /// <summary>The parts of edges that follow each other.</summary>
    public static List<GraphEdge> Open(PieceGraph graph, IReadOnlyList<int> edges)
    {
        var parts = new List<GraphEdge>(edges.Count);
        for (var i = 0; i < edges.Count; i++)
        {
            var part = graph.Edges[edges[i]];
            for (; i + 1 < edges.Count && Continues(graph, edges[i], edges[i + 1]); i++)
            {
                var next = graph.Edges[edges[i + 1]];
                part = part with { To = part.To + (next.To - next.From), End = next.End };
            }

            parts.Add(part);
        }

        return parts;
    }

    /// <summary>True when the second edge is the next part of the same piece; a full circle also continues from its end to its start.</summary>
    private static bool Continues(PieceGraph graph, int edge, int next)
    {
        var (before, after) = (graph.Edges[edge], graph.Edges[next]);
        if (edge == next || before.Piece != after.Piece || before.End != after.Start || before.To > before.From != after.To > after.From) return false;
        return before.To == after.From || Math.Abs(before.To - after.From) == 1.0;
    }
}
