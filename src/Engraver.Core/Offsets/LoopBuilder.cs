using Engraver.Core.Geometry;

namespace Engraver.Core.Offsets;

/// <summary>Converts a run of edges to segments: consecutive parts of one raw piece become one segment again.</summary>
internal static class LoopBuilder
{
    /// <summary>A closed loop, moved; no segment begins within a raw piece.</summary>
    public static OffsetLoop Closed(RawGraph graph, IReadOnlyList<int> edges, Vector2D by)
    {
        var first = 0;
        while (first < edges.Count && Continues(graph, edges[(first + edges.Count - 1) % edges.Count], edges[first])) first++;
        if (first == edges.Count) first = 0;
        return Built(graph, closed: true, [.. Enumerable.Range(0, edges.Count).Select(i => edges[(first + i) % edges.Count])], by);
    }

    /// <summary>Edges that follow each other, moved.</summary>
    public static OffsetLoop Open(RawGraph graph, IReadOnlyList<int> edges, Vector2D by) => Built(graph, closed: false, edges, by);

    private static OffsetLoop Built(RawGraph graph, bool closed, IReadOnlyList<int> edges, Vector2D by)
    {
        var (segments, sources) = (new List<Segment>(edges.Count), new List<OffsetSource>(edges.Count));
        for (var i = 0; i < edges.Count;)
        {
            var (part, last) = (graph.Edges[edges[i]], i);
            for (; last + 1 < edges.Count && Continues(graph, edges[last], edges[last + 1]); last++)
            {
                var next = graph.Edges[edges[last + 1]];
                part = part with { To = part.To + (next.To - next.From), End = next.End };
            }

            segments.Add(graph.PieceOf(part).Moved(by).ToSegment());
            sources.Add(graph.SourceOf(part));
            i = last + 1;
        }

        return new OffsetLoop(segments, closed) { Sources = sources };
    }

    /// <summary>True when the second edge is the next part of the same raw piece; a full circle also continues from its end to its start.</summary>
    private static bool Continues(RawGraph graph, int edge, int next)
    {
        var (before, after) = (graph.Edges[edge], graph.Edges[next]);
        return edge != next && before.Raw == after.Raw && before.End == after.Start && (before.To == after.From || (before.To == 1.0 && after.From == 0.0));
    }
}
