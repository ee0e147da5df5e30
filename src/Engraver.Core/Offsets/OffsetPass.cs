using Engraver.Core.Geometry;
using Engraver.Core.Offsets.Graphs;
using Engraver.Core.Offsets.Pieces;

namespace Engraver.Core.Offsets;

/// <summary>One computation from closed chains to the loops around the free area.</summary>
internal sealed class OffsetPass
{
    /// <summary>Distances to try, as differences from the requested distance in tolerances. Where a contour touches itself at so many points that a crossing is
    /// evaluated in two ways, a slightly larger or smaller distance avoids this.</summary>
    private static readonly double[] Attempts = [0.0, 3.0, -3.0, 7.0, -7.0];

    /// <summary>Coarser tolerances for a drawing that almost coincides with itself, as multiples.</summary>
    private static readonly double[] Coarser = [1.0, 30.0, 1_000.0];

    private OffsetPass(RawGraph graph, GraphLoops boundary) => (Graph, Loops, Unresolved) = (graph, boundary.Loops(), [.. boundary.Unbalanced.Select(graph.Pieces.PlaceOf)]);

    public RawGraph Graph { get; }

    /// <summary>Numbers of edges, with the free area on their left.</summary>
    public List<List<int>> Loops { get; }

    /// <summary>Points where the loops could not be closed and a part was left out.</summary>
    public IReadOnlyList<Point2D> Unresolved { get; }

    /// <param name="source">All drawn segments that must be kept clear.</param>
    /// <param name="chains">Chains whose left sides are offset.</param>
    /// <param name="distance">Offset distance, millimetres, above 0.</param>
    /// <param name="options">The join.</param>
    /// <param name="tolerance">Length that counts as zero.</param>
    public static OffsetPass Run(PieceTree source, IReadOnlyList<RawChain> chains, double distance, OffsetOptions options, double tolerance)
    {
        OffsetPass? best = null;
        foreach (var length in Coarser.Select(factor => factor * tolerance))
        {
            foreach (var attempt in Attempts)
            {
                var pass = RunOnce(source, chains, distance + (attempt * length), options, length);
                if (best is null || pass.Unresolved.Count < best.Unresolved.Count) best = pass;
                if (best.Unresolved.Count == 0) return best;
            }
        }

        return best!;
    }

    private static OffsetPass RunOnce(PieceTree source, IReadOnlyList<RawChain> chains, double distance, OffsetOptions options, double tolerance)
    {
        var raw = new RawOffset(distance, options, tolerance);
        foreach (var chain in chains) raw.Add(chain);
        var graph = RawGraph.From(raw, options.Join == OffsetJoin.Bevel ? null : source);
        return new OffsetPass(graph, new FreeBoundary(graph, new OffsetReach(source, chains, distance, options, tolerance)).Loops());
    }
}
