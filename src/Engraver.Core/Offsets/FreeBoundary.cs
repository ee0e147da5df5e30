using Engraver.Core.Offsets.Graphs;

namespace Engraver.Core.Offsets;

/// <summary>The edges of the raw graph that bound the free area. The longest edge of a run decides for the whole run.</summary>
internal sealed class FreeBoundary(RawGraph graph, OffsetReach reach)
{
    private readonly PieceGraph _pieces = graph.Pieces;

    public GraphLoops Loops() => GraphLoops.From(_pieces, edge => !graph.IsGone(edge), run => IsFree(Longest(run)) ? RunUse.Forwards : RunUse.None);

    private int Longest(IReadOnlyList<int> run)
    {
        var longest = run[0];
        foreach (var edge in run) longest = _pieces.LengthOf(edge) > _pieces.LengthOf(longest) ? edge : longest;
        return longest;
    }

    /// <summary>Three points, because in a symmetrical drawing an inside tangent point is at the middle.</summary>
    private bool IsFree(int edge) => reach.IsFree(_pieces.PointOn(edge, 0.5)) && reach.IsFree(_pieces.PointOn(edge, 0.29)) && reach.IsFree(_pieces.PointOn(edge, 0.73));
}
