using System.Runtime.InteropServices;
using Engraver.Core.Geometry;
using Engraver.Core.Offsets.Pieces;

namespace Engraver.Core.Offsets;

/// <summary>A part of a raw piece between two nodes, in its direction.</summary>
/// <param name="Raw">Number of the raw piece.</param>
/// <param name="From">Fraction of the raw piece at which it begins.</param>
/// <param name="To">Fraction at which it ends.</param>
/// <param name="Start">Node at its start.</param>
/// <param name="End">Node at its end; for a whole circle the same.</param>
internal readonly record struct RawEdge(int Raw, double From, double To, int Start, int End);

/// <summary>The raw offset cut at every point where it crosses itself: nodes and edges. Points that coincide within the tolerance are one node, so that edges
/// are joined by number and never by distance.</summary>
/// <remarks>Two edges that coincide in opposite directions cancel: there is no free area between them (walls exactly two distances apart). Two edges in the
/// same direction count as one.</remarks>
internal sealed class RawGraph
{
    /// <summary>Nodes nearer to each other than this many tolerances are merged: a crossing at a small angle is not found more exactly.</summary>
    private const double NodeTolerances = 4.0;

    private readonly IReadOnlyList<RawPiece> _raw;
    private readonly double _tolerance;
    private readonly List<RawEdge> _edges = [];
    private readonly NodeMerger _nodes;
    private bool[] _gone = [];
    private RawSides[] _sides = [];

    private RawGraph(RawOffset raw, CoveredEnds ends)
    {
        _raw = ends.Pieces;
        _tolerance = raw.Tolerance;
        _nodes = new NodeMerger(ends.Nodes, raw.Same, NodeTolerances * raw.Tolerance);
    }

    /// <summary>Length that counts as zero.</summary>
    public double Tolerance => _tolerance;

    public IReadOnlyList<RawEdge> Edges => _edges;

    public int NodeCount => _nodes.Count;

    /// <param name="raw">The raw offset.</param>
    /// <param name="source">The drawn segments, when all points nearer to them than the distance are covered; null when corners have another shape.</param>
    public static RawGraph From(RawOffset raw, PieceTree? source)
    {
        var graph = new RawGraph(raw, CoveredEnds.TakenFrom(raw, source));
        graph.AddEdges(graph.FindCuts());
        graph.RemoveCoincident();
        return graph;
    }

    public Point2D PlaceOf(int node) => _nodes.PlaceOf(node);

    /// <summary>True for an edge that coincides with another and is not counted.</summary>
    public bool IsGone(int edge) => _gone[edge];

    /// <summary>The part of the raw piece between the edge's nodes.</summary>
    public PathPiece PieceOf(in RawEdge part) => _raw[part.Raw].Piece.Part(part.From, PlaceOf(part.Start), part.To, PlaceOf(part.End));

    /// <summary>The source of an edge.</summary>
    public OffsetSource SourceOf(in RawEdge edge) => _raw[edge.Raw].Source;

    /// <summary>The sides of all edges that coincide with it in its direction.</summary>
    public RawSides SidesOf(int edge) => _sides[edge];

    public Point2D PointOn(int edge, double fraction) => _raw[_edges[edge].Raw].Piece.At(_edges[edge].From + ((_edges[edge].To - _edges[edge].From) * fraction));

    public double LengthOf(int edge) => _raw[_edges[edge].Raw].Piece.Length * (_edges[edge].To - _edges[edge].From);

    private List<RawCut> FindCuts()
    {
        var pieces = new PathPiece[_raw.Count];
        for (var i = 0; i < pieces.Length; i++) pieces[i] = _raw[i].Piece;
        var cuts = new List<RawCut>();
        Span<Crossing> found = stackalloc Crossing[PieceCrossings.MaxCount];
        foreach (var (first, second) in new PieceTree(pieces).Pairs(_tolerance))
        {
            var count = PieceCrossings.Between(pieces[first], pieces[second], _tolerance, found);
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
        var (a, b) = (_raw[first], _raw[second]);
        return (a.End == b.Start && IsBeside(a.Piece.EndTangent, b.Piece.StartTangent, a, b, a.Piece.End, place))
            || (b.End == a.Start && IsBeside(b.Piece.EndTangent, a.Piece.StartTangent, a, b, a.Piece.Start, place));
    }

    private bool IsBeside(Vector2D leaving, Vector2D arriving, in RawPiece a, in RawPiece b, Point2D joint, Point2D place)
    {
        var error = PieceCrossings.JointError(leaving, arriving, Math.Max(a.Piece.Radius, b.Piece.Radius)) ?? 0.0;
        return place.IsNear(joint, (NodeTolerances * _tolerance) + error);
    }

    private void AddCut(List<RawCut> cuts, int first, int second, in Crossing crossing)
    {
        var node = _nodes.NodeAt(crossing.Place, EndAt(first, crossing.OnFirst), EndAt(second, crossing.OnSecond));
        if (crossing.OnFirst is > 0.0 and < 1.0) cuts.Add(new RawCut(first, crossing.OnFirst, node));
        if (crossing.OnSecond is > 0.0 and < 1.0) cuts.Add(new RawCut(second, crossing.OnSecond, node));
    }

    private int EndAt(int raw, double fraction) => fraction == 0.0 ? _raw[raw].Start : fraction == 1.0 ? _raw[raw].End : -1;

    private void AddEdges(List<RawCut> cuts)
    {
        cuts.Sort(static (a, b) => a.Raw != b.Raw ? a.Raw.CompareTo(b.Raw) : a.At.CompareTo(b.At));
        _edges.EnsureCapacity(_raw.Count + cuts.Count);
        var next = 0;
        for (var raw = 0; raw < _raw.Count; raw++)
        {
            var (from, start) = (0.0, _raw[raw].Start);
            for (; next < cuts.Count && cuts[next].Raw == raw; next++)
            {
                AddEdge(raw, from, cuts[next].At, start, cuts[next].Node);
                (from, start) = (cuts[next].At, cuts[next].Node);
            }

            AddEdge(raw, from, 1.0, start, _raw[raw].End);
        }
    }

    private void AddEdge(int raw, double from, double to, int start, int end)
    {
        (start, end) = (_nodes.Of(start), _nodes.Of(end));
        if (start == end && _raw[raw].Piece.Length * (to - from) <= 8.0 * NodeTolerances * _tolerance) return;
        _edges.Add(new RawEdge(raw, from, to, start, end));
    }

    private void RemoveCoincident()
    {
        _gone = new bool[_edges.Count];
        _sides = [.. _edges.Select(edge => _raw[edge.Raw].Side)];
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

        foreach (var list in between.Values.Where(list => list.Count > 1)) RemoveCoincident(list);
    }

    private void RemoveCoincident(List<int> edges)
    {
        for (var i = 0; i < edges.Count; i++)
        {
            var opposite = false;
            for (var j = i + 1; j < edges.Count; j++)
            {
                if (_gone[edges[i]] || _gone[edges[j]] || !Coincide(edges[i], edges[j])) continue;
                _gone[edges[j]] = true;
                _sides[edges[i]] |= _sides[edges[j]];
                opposite |= IsOpposite(edges[i], edges[j]);
            }

            _gone[edges[i]] |= opposite;
        }
    }

    private bool Coincide(int first, int second)
    {
        var middle = PointOn(first, 0.5);
        return middle.IsNear(PointOn(second, 0.5), 2.0 * NodeTolerances * _tolerance);
    }

    private bool IsOpposite(int first, int second)
    {
        if (_edges[first].Start != _edges[first].End) return _edges[first].Start == _edges[second].End;
        return _raw[_edges[first].Raw].Piece.Sweep * _raw[_edges[second].Raw].Piece.Sweep < 0.0;
    }

    private readonly record struct RawCut(int Raw, double At, int Node);
}
