using System.Runtime.InteropServices;
using Engraver.Core.Geometry;
using Engraver.Core.Offsets.Pieces;

namespace Engraver.Core.Offsets.Graphs;

/// <summary>Chains of pieces cut at every point where they cross: nodes and edges. Points that coincide within the tolerance are one node, so that edges are
/// joined by number and never by distance.</summary>
internal sealed class PieceGraph
{
    /// <summary>Nodes nearer to each other than this many tolerances are merged: a crossing at a small angle is not found more exactly.</summary>
    public const double NodeTolerances = 4.0;

    private readonly PathPiece[] _pieces;
    private readonly (int Start, int End)[] _ends;
    private readonly NodeMerger _nodes;
    private readonly PieceContact _contact;
    private readonly List<GraphEdge> _edges = [];
    private readonly Dictionary<int, List<int>> _bundles = [];
    private int[] _leaders = [];

    private PieceGraph(PathPiece[] pieces, (int Start, int End)[] ends, NodeMerger nodes, double tolerance, PieceContact contact) =>
        (_pieces, _ends, _nodes, Tolerance, _contact) = (pieces, ends, nodes, tolerance, contact);

    /// <summary>Length that counts as zero.</summary>
    public double Tolerance { get; }

    public IReadOnlyList<GraphEdge> Edges => _edges;

    public int NodeCount => _nodes.Count;

    /// <param name="tree">The pieces.</param>
    /// <param name="ends">Start and end node of each piece.</param>
    /// <param name="nodes">The nodes, merged at <see cref="NodeTolerances"/>.</param>
    /// <param name="tolerance">Length that counts as zero.</param>
    /// <param name="contact">Which common points become nodes.</param>
    public static PieceGraph From(PieceTree tree, (int Start, int End)[] ends, NodeMerger nodes, double tolerance, PieceContact contact)
    {
        var graph = new PieceGraph([.. tree.Pieces], ends, nodes, tolerance, contact);
        var cuts = graph.FindCuts(tree);
        if (contact == PieceContact.CrossingsAndEnds) graph.CutPassing(tree, cuts);
        graph.AddEdges(cuts);
        graph.FindBundles();
        return graph;
    }

    public Point2D PlaceOf(int node) => _nodes.PlaceOf(node);

    /// <summary>The part of the piece between the edge's nodes.</summary>
    public PathPiece PieceOf(in GraphEdge part) => _pieces[part.Piece].Part(part.From, PlaceOf(part.Start), part.To, PlaceOf(part.End));

    public Point2D PointOn(int edge, double fraction) => _pieces[_edges[edge].Piece].At(_edges[edge].From + ((_edges[edge].To - _edges[edge].From) * fraction));

    public double LengthOf(int edge) => _pieces[_edges[edge].Piece].Length * Math.Abs(_edges[edge].To - _edges[edge].From);

    /// <summary>The first of the edges that coincide with an edge; itself when it is the first or the only one.</summary>
    public int LeaderOf(int edge) => _leaders[edge];

    /// <summary>All edges that coincide with a leader, which is the first of them.</summary>
    public IReadOnlyList<int> BundleOf(int leader) => _bundles.TryGetValue(leader, out var bundle) ? bundle : [leader];

    /// <summary>True when two edges that coincide have opposite directions.</summary>
    public bool AreOpposite(int first, int second)
    {
        var (a, b) = (_edges[first], _edges[second]);
        if (a.Start != a.End) return a.Start == b.End;
        return _pieces[a.Piece].Sweep * (a.To - a.From) * _pieces[b.Piece].Sweep * (b.To - b.From) < 0.0;
    }

    /// <summary>Lets an edge run in the opposite direction.</summary>
    public void Reverse(int edge) => _edges[edge] = _edges[edge].Reversed();

    private List<PieceCut> FindCuts(PieceTree tree)
    {
        var cuts = new List<PieceCut>();
        Span<Crossing> found = stackalloc Crossing[PieceCrossings.MaxCount];
        foreach (var (first, second) in tree.Pairs(Tolerance))
        {
            var count = _contact == PieceContact.Crossings
                ? PieceCrossings.Between(_pieces[first], _pieces[second], Tolerance, found)
                : PieceCrossings.BetweenWithEnds(_pieces[first], _pieces[second], Tolerance, found);
            for (var i = 0; i < count; i++)
            {
                if (!IsJoint(first, second, found[i].Place)) AddCut(cuts, first, second, found[i]);
            }
        }

        return cuts;
    }

    /// <summary>True for the point at which two neighbours are joined. Where they are almost tangent, the computed point can be away from their node.</summary>
    private bool IsJoint(int first, int second, Point2D place)
    {
        var (a, b) = (_pieces[first], _pieces[second]);
        return (_ends[first].End == _ends[second].Start && IsBeside(a.EndTangent, b.StartTangent, a, b, a.End, place))
            || (_ends[second].End == _ends[first].Start && IsBeside(b.EndTangent, a.StartTangent, a, b, a.Start, place));
    }

    private bool IsBeside(Vector2D leaving, Vector2D arriving, in PathPiece a, in PathPiece b, Point2D joint, Point2D place)
    {
        var error = _contact == PieceContact.Crossings ? PieceCrossings.JointError(leaving, arriving, Math.Max(a.Radius, b.Radius)) ?? 0.0 : 0.0;
        return place.IsNear(joint, (NodeTolerances * Tolerance) + error);
    }

    private void AddCut(List<PieceCut> cuts, int first, int second, in Crossing crossing)
    {
        var node = _nodes.NodeAt(crossing.Place, EndAt(first, crossing.OnFirst), EndAt(second, crossing.OnSecond));
        if (crossing.OnFirst is > 0.0 and < 1.0) cuts.Add(new PieceCut(first, crossing.OnFirst, node));
        if (crossing.OnSecond is > 0.0 and < 1.0) cuts.Add(new PieceCut(second, crossing.OnSecond, node));
    }

    /// <summary>Cuts every piece that passes through a node where others cross. Of two pieces that almost coincide, a third that crosses both at a small angle
    /// gives nodes far apart; both pieces have both nodes, so that their parts coincide.</summary>
    private void CutPassing(PieceTree tree, List<PieceCut> cuts)
    {
        var (nodes, near) = (new HashSet<int>(), new List<int>());
        var known = cuts.Select(cut => (cut.Piece, _nodes.Of(cut.Node))).ToHashSet();
        for (var i = cuts.Count - 1; i >= 0; i--)
        {
            var node = _nodes.Of(cuts[i].Node);
            if (!nodes.Add(node)) continue;
            var place = PlaceOf(node);
            near.Clear();
            tree.AddNear(place, 2.0 * Tolerance, near);
            foreach (var piece in near)
            {
                if (_nodes.Of(_ends[piece].Start) == node || _nodes.Of(_ends[piece].End) == node || known.Contains((piece, node)) || _pieces[piece].DistanceTo(place) > 2.0 * Tolerance) continue;
                var (fraction, slack) = (_pieces[piece].FractionOf(place), NodeTolerances * Tolerance / _pieces[piece].Length);
                if (fraction > slack && fraction < 1.0 - slack) cuts.Add(new PieceCut(piece, fraction, node));
                else _nodes.NodeAt(place, node, fraction <= slack ? _ends[piece].Start : _ends[piece].End);
            }
        }
    }

    private int EndAt(int piece, double fraction) => fraction == 0.0 ? _ends[piece].Start : fraction == 1.0 ? _ends[piece].End : -1;

    private void AddEdges(List<PieceCut> cuts)
    {
        cuts.Sort(static (a, b) => a.Piece != b.Piece ? a.Piece.CompareTo(b.Piece) : a.At.CompareTo(b.At));
        _edges.EnsureCapacity(_pieces.Length + cuts.Count);
        var next = 0;
        for (var piece = 0; piece < _pieces.Length; piece++)
        {
            var (from, start) = (0.0, _ends[piece].Start);
            for (; next < cuts.Count && cuts[next].Piece == piece; next++)
            {
                AddEdge(piece, from, cuts[next].At, start, cuts[next].Node);
                (from, start) = (cuts[next].At, cuts[next].Node);
            }

            AddEdge(piece, from, 1.0, start, _ends[piece].End);
        }
    }

    private void AddEdge(int piece, double from, double to, int start, int end)
    {
        (start, end) = (_nodes.Of(start), _nodes.Of(end));
        if (start == end && _pieces[piece].Length * (to - from) <= 8.0 * NodeTolerances * Tolerance) return;
        _edges.Add(new GraphEdge(piece, from, to, start, end));
    }

    private void FindBundles()
    {
        _leaders = [.. Enumerable.Range(0, _edges.Count)];
        var degree = new int[_nodes.Count];
        foreach (var edge in _edges)
        {
            degree[edge.Start]++;
            degree[edge.End]++;
        }

        var between = new Dictionary<(int, int), List<int>>();
        for (var i = 0; i < _edges.Count; i++)
        {
            var edge = _edges[i];
            if (degree[edge.Start] <= 2 && degree[edge.End] <= 2) continue;
            ref var list = ref CollectionsMarshal.GetValueRefOrAddDefault(between, (Math.Min(edge.Start, edge.End), Math.Max(edge.Start, edge.End)), out _);
            list ??= [];
            list.Add(i);
        }

        foreach (var list in between.Values.Where(list => list.Count > 1)) FindBundles(list);
    }

    private void FindBundles(List<int> edges)
    {
        for (var i = 0; i < edges.Count; i++)
        {
            if (_leaders[edges[i]] != edges[i]) continue;
            for (var j = i + 1; j < edges.Count; j++)
            {
                if (_leaders[edges[j]] != edges[j] || !Coincide(edges[i], edges[j])) continue;
                _leaders[edges[j]] = edges[i];
                ref var bundle = ref CollectionsMarshal.GetValueRefOrAddDefault(_bundles, edges[i], out _);
                (bundle ??= [edges[i]]).Add(edges[j]);
            }
        }
    }

    private bool Coincide(int first, int second) => PointOn(first, 0.5).IsNear(PointOn(second, 0.5), 2.0 * NodeTolerances * Tolerance);

    private readonly record struct PieceCut(int Piece, double At, int Node);
}
