using Engraver.Core.Geometry;

namespace Engraver.Core.Sequencing.Ordering.Optimising;

/// <summary>Nodes to visit in an order of least travel. Node 0 is the tool: it is left at the start and entered at the end. The others are strokes, numbered in
/// the order from which the search starts.</summary>
internal sealed class OrderProblem
{
    /// <summary>Places are rounded to this fraction of a millimetre, so that the last digits of sines and cosines, which differ between processors, do not
    /// change the order.</summary>
    private const double PlacesPerMm = 1e6;

    private readonly List<int> _firstPlace = [0];
    private readonly List<Point2D> _places = [];
    private readonly List<NodeKind> _kinds = [];
    private readonly List<int> _entries = [];
    private readonly List<(int Before, int After)> _pairs = [];

    /// <param name="start">Position of the tool before the first stroke, mm.</param>
    /// <param name="end">Position that it moves to after the last stroke; null: it stays there.</param>
    public OrderProblem(Point2D start, Point2D? end)
    {
        EndIsFree = end is null;
        Add(NodeKind.Directed, [end ?? new Point2D(double.NaN, double.NaN), start], 0);
    }

    /// <summary>Number of nodes, with the tool.</summary>
    public int Count => _kinds.Count;

    /// <summary>The tool does not move after the last stroke.</summary>
    public bool EndIsFree { get; }

    /// <summary>Some nodes must come before others or have one direction: the order cannot be reversed as a whole.</summary>
    public bool IsConstrained { get; private set; }

    /// <summary>Each pair of nodes of which one must come before the other.</summary>
    public IReadOnlyList<(int Before, int After)> Pairs => _pairs;

    /// <summary>Adds the next node.</summary>
    /// <param name="places">Possible starts; of an open contour its two ends.</param>
    /// <param name="entry">Number of the place at which it starts at first.</param>
    public void Add(NodeKind kind, ReadOnlySpan<Point2D> places, int entry)
    {
        IsConstrained |= kind == NodeKind.Directed && Count > 0;
        _kinds.Add(kind);
        _entries.Add(entry);
        foreach (var place in places) _places.Add(new Point2D(Rounded(place.X), Rounded(place.Y)));
        _firstPlace.Add(_places.Count);
    }

    /// <summary>Requires one node before another.</summary>
    /// <param name="before">Lower than <paramref name="after"/>: the first order already complies.</param>
    public void Require(int before, int after)
    {
        _pairs.Add((before, after));
        IsConstrained = true;
    }

    public NodeKind KindOf(int node) => _kinds[node];

    /// <summary>Number of the place at which a node starts at first.</summary>
    public int FirstEntryOf(int node) => _entries[node];

    public ReadOnlySpan<Point2D> PlacesOf(int node) => System.Runtime.InteropServices.CollectionsMarshal.AsSpan(_places)[_firstPlace[node].._firstPlace[node + 1]];

    /// <summary>Where the tool enters and leaves a node with an entry.</summary>
    public NodeEnds EndsOf(int node, int entry)
    {
        var places = PlacesOf(node);
        var (start, end) = (places[entry], places[_kinds[node] == NodeKind.Closed ? entry : 1 - entry]);
        return new NodeEnds(start.X, start.Y, end.X, end.Y);
    }

    private static double Rounded(double mm) => Math.Round(mm * PlacesPerMm) / PlacesPerMm;
}
