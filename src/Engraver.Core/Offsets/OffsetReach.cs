using Engraver.Core.Geometry;
using Engraver.Core.Offsets.Pieces;

namespace Engraver.Core.Offsets;

/// <summary>The area that an offset must keep clear of: all points nearer to the drawing than the distance, with the corners in the shape of their
/// joins.</summary>
internal sealed class OffsetReach
{
    private readonly PieceTree _source;
    private readonly double _distance;
    private readonly OffsetOptions _options;
    private readonly double _tolerance;
    private readonly CornerReach? _corners;

    /// <param name="source">All drawn segments.</param>
    /// <param name="chains">The closed chains whose left side is offset.</param>
    /// <param name="distance">Offset distance, millimetres.</param>
    /// <param name="options">The join.</param>
    /// <param name="tolerance">Depth that is ignored.</param>
    public OffsetReach(PieceTree source, IReadOnlyList<RawChain> chains, double distance, OffsetOptions options, double tolerance)
    {
        (_source, _distance, _options, _tolerance) = (source, distance, options, tolerance);
        if (options.Join != OffsetJoin.Round) _corners = new CornerReach(chains, distance, options, tolerance);
    }

    public OffsetJoin Join => _options.Join;

    /// <summary>True when the place is not nearer than the distance.</summary>
    public bool IsFree(Point2D place) => _corners?.IsFree(place) ?? !_source.IsAnyWithin(place, _distance - _tolerance);
}

/// <summary>The same with mitres or bevels: the strips along the pieces, and the shape of every corner on its outside.</summary>
internal sealed class CornerReach
{
    private readonly PieceTree _tree;
    private readonly PathPiece[] _pieces;
    private readonly int[] _next;
    private readonly bool[] _isCap;
    private readonly double _distance;
    private readonly OffsetOptions _options;
    private readonly double _tolerance;
    private readonly List<int> _near = [];

    public CornerReach(IReadOnlyList<RawChain> chains, double distance, OffsetOptions options, double tolerance)
    {
        (_distance, _options, _tolerance) = (distance, options, tolerance);
        _pieces = [.. chains.SelectMany(chain => chain.Pieces)];
        _tree = new PieceTree(_pieces);
        (_next, _isCap) = (new int[_pieces.Length], new bool[_pieces.Length]);
        var first = 0;
        foreach (var chain in chains)
        {
            var count = chain.Pieces.Length;
            for (var i = 0; i < count; i++) (_next[first + i], _isCap[first + i]) = (first + ((i + 1) % count), chain.IsCapBehind(i));
            first += count;
        }
    }

    public bool IsFree(Point2D place)
    {
        var reach = _distance * (_options.Join == OffsetJoin.Mitre ? _options.MitreLimit : 1.0);
        _near.Clear();
        _tree.AddNear(place, reach, _near);
        foreach (var piece in _near)
        {
            if (IsInStrip(_pieces[piece], place) || IsInCorner(piece, place)) return false;
        }

        return true;
    }

    /// <summary>Between the piece and either of its parallels. The strip on the concave side of an arc continues beyond the centre.</summary>
    private bool IsInStrip(in PathPiece piece, Point2D place)
    {
        if (!piece.IsArc)
        {
            var along = (piece.End - piece.Start) * (1.0 / piece.Length);
            var way = place - piece.Start;
            return along.Dot(way) >= 0.0 && along.Dot(way) <= piece.Length && Math.Abs(along.Cross(way)) < _distance - _tolerance;
        }

        var spoke = place - piece.Centre;
        var radius = PathPiece.Norm(spoke);
        if (piece.Covers(spoke) && Math.Abs(radius - piece.Radius) < _distance - _tolerance) return true;
        return radius + piece.Radius < _distance - _tolerance && piece.Covers(-spoke);
    }

    private bool IsInCorner(int piece, Point2D place)
    {
        var (leaving, arriving) = (_pieces[piece].EndTangent, _pieces[_next[piece]].StartTangent);
        var way = place - _pieces[piece].End;
        if (_isCap[piece]) return PathPiece.Norm(way) < _distance - _tolerance;
        if (leaving.Cross(arriving) > 0.0 || way.Dot(leaving) < 0.0 || way.Dot(arriving) > 0.0) return false;
        var (before, after) = (leaving.Cross(way), arriving.Cross(way)); // heights above both sides
        if (OffsetCorner.Mitre(_pieces[piece].End, leaving, arriving, _distance, _options) is not null) return Math.Max(before, after) is > 0.0 and var height && height < _distance - _tolerance; // without a turn, the part after the corner is also on its line
        var cosine = Math.Sqrt(Math.Max(0.0, (1.0 + leaving.Dot(arriving)) / 2.0)); // cosine of half the turn
        return cosine > 0.0 && (before + after) / (2.0 * cosine) < (_distance * cosine) - _tolerance && before > 0.0 && after > 0.0;
    }
}
