using Engraver.Core.Geometry;
using Engraver.Core.Offsets.Graphs;
using Engraver.Core.Offsets.Pieces;

namespace Engraver.Core.Unions;

/// <summary>The edges with winding number 0 on one side and another on the other side.</summary>
internal sealed class UnionBoundary
{
    /// <summary>Number of edges of a run, the longest first, at which its winding numbers are measured until a place is clear of all other edges.</summary>
    private const int MaxEdges = 3;

    /// <summary>Distance from all other edges at which a place is clear, in tolerances.</summary>
    private const double ClearTolerances = 64.0;

    /// <summary>Distance that is searched for other edges, as a part of the edge's length.</summary>
    private const double SearchedLength = 0.125;

    /// <summary>Where on an edge it is measured; in a symmetrical drawing several contours can meet at the middle.</summary>
    private static readonly double[] Fractions = [0.5, 0.29, 0.73];

    private readonly PieceGraph _graph;
    private readonly PieceTree _tree;
    private readonly WindingNumbers _windings;
    private readonly int[] _turns;
    private readonly List<int> _near = [];

    public UnionBoundary(PieceGraph graph, PieceTree tree, WindingNumbers windings)
    {
        (_graph, _tree, _windings) = (graph, tree, windings);
        _turns = new int[graph.Edges.Count];
        for (var edge = 0; edge < _turns.Length; edge++)
        {
            var leader = graph.LeaderOf(edge);
            _turns[leader] += leader != edge && graph.AreOpposite(leader, edge) ? -1 : 1;
        }

        for (var edge = 0; edge < _turns.Length; edge++)
        {
            if (_turns[edge] >= 0) continue;
            _turns[edge] = -_turns[edge];
            graph.Reverse(edge);
        }
    }

    public GraphLoops Loops() => GraphLoops.From(_graph, edge => _turns[edge] > 0, Use);

    private RunUse Use(IReadOnlyList<int> run)
    {
        var best = default(SideWindings?);
        foreach (var edge in run.OrderByDescending(_graph.LengthOf).Take(MaxEdges))
        {
            foreach (var fraction in Fractions)
            {
                var sides = Measured(edge, fraction);
                if (best is null || sides.IsBetterThan(best.Value)) best = sides;
                if (best.Value.IsConsistent && best.Value.Clearance > ClearTolerances * _graph.Tolerance) return best.Value.Use;
            }
        }

        return best!.Value.Use;
    }

    private SideWindings Measured(int edge, double fraction)
    {
        const double Step = 0.1;
        var place = _graph.PointOn(edge, fraction);
        var chord = _graph.PointOn(edge, fraction + Step) - _graph.PointOn(edge, fraction - Step); // parallel to the tangent in the middle of it
        var clearance = Clearance(edge, place);
        var beside = new Vector2D(-chord.Y, chord.X) * (clearance / (2.0 * PathPiece.Norm(chord)));
        var (left, right) = (_windings.At(place + beside), _windings.At(place - beside));
        return new SideWindings(left, right, clearance, left - right == _turns[edge]);
    }

    /// <summary>Distance of the nearest piece that does not coincide with the edge, within a part of its length.</summary>
    private double Clearance(int edge, Point2D place)
    {
        var clearance = SearchedLength * _graph.LengthOf(edge);
        _near.Clear();
        _tree.AddNear(place, clearance, _near);
        var bundle = _graph.BundleOf(edge);
        foreach (var piece in _near)
        {
            if (!IsIn(bundle, piece)) clearance = Math.Min(clearance, _tree.Pieces[piece].DistanceTo(place));
        }

        return clearance;
    }

    private bool IsIn(IReadOnlyList<int> bundle, int piece)
    {
        foreach (var edge in bundle)
        {
            if (_graph.Edges[edge].Piece == piece) return true;
        }

        return false;
    }

    /// <param name="Clearance">Distance of the nearest other edge.</param>
    /// <param name="IsConsistent">True when the difference is the number of edges that coincide.</param>
    private readonly record struct SideWindings(int Left, int Right, double Clearance, bool IsConsistent)
    {
        public RunUse Use => Left == 0 == (Right == 0) ? RunUse.None : Left != 0 ? RunUse.Forwards : RunUse.Backwards;

        public bool IsBetterThan(in SideWindings other) => IsConsistent == other.IsConsistent ? Clearance > other.Clearance : IsConsistent;
    }
}
