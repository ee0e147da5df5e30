using Engraver.Core.Geometry;
using Engraver.Core.Offsets.Pieces;

namespace Engraver.Core.Offsets;

/// <summary>Removes the loose ends of a raw offset: where a chain is interrupted, its end is nearer to the drawing than the distance, and so are all following
/// pieces up to the boundary of the free area.</summary>
/// <remarks>Where the distance is large compared with the teeth of a contour, nearly the whole raw offset is loose, and the number of its self-intersections
/// would grow with the square. The removed parts are certainly too near; the remaining parts are tested later, so that their amount does not affect the
/// result.</remarks>
internal sealed class CoveredEnds
{
    /// <summary>Fraction of the distance, and number of tolerances, by which removed parts must be nearer; and the additional allowance of smooth
    /// joints.</summary>
    private const double Depth = 1e-6;

    private const double DepthTolerances = 16.0;

    /// <summary>Fraction of the distance: closer to the boundary than this, a further step is not worth the search.</summary>
    private const double MinStep = 1e-3;

    /// <summary>Maximum number of points at which one end of a piece is measured.</summary>
    private const int MaxSteps = 40;

    /// <summary>Number of pieces before and after that are checked before all others are searched: between narrow teeth they cover nearly the whole covered
    /// part.</summary>
    private const int Neighbours = 4;

    private readonly PieceTree? _source;
    private readonly IReadOnlyList<PathPiece> _drawn;
    private readonly double _radius;
    private readonly RawPiece[] _pieces;
    private readonly bool[] _gone;
    private readonly int[] _pieceBefore;
    private readonly int[] _pieceBehind;
    private readonly bool[] _continues;
    private readonly List<Point2D> _nodes;

    private CoveredEnds(RawOffset raw, PieceTree? source)
    {
        (_source, _drawn, _radius) = (source, raw.Drawn, (raw.Distance * (1.0 - Depth)) - (DepthTolerances * raw.Tolerance) - raw.Smoothness);
        (_pieces, _nodes) = ([.. raw.Pieces], [.. raw.Nodes]);
        _gone = new bool[_pieces.Length];
        (_pieceBefore, _pieceBehind) = (new int[_nodes.Count], new int[_nodes.Count]);
        Array.Fill(_pieceBefore, -1);
        Array.Fill(_pieceBehind, -1);
        for (var i = 0; i < _pieces.Length; i++) (_pieceBehind[_pieces[i].Start], _pieceBefore[_pieces[i].End]) = (i, i);
        _continues = new bool[_nodes.Count];
        foreach (var (one, other) in raw.Same) _continues[one] = _continues[other] = true;
    }

    /// <summary>The remaining pieces, in the same order.</summary>
    public IReadOnlyList<RawPiece> Pieces
    {
        get
        {
            var (left, count) = (new RawPiece[_gone.Count(isGone => !isGone)], 0);
            for (var i = 0; i < _pieces.Length; i++) if (!_gone[i]) left[count++] = _pieces[i];
            return left;
        }
    }

    public IReadOnlyList<Point2D> Nodes => _nodes;

    /// <param name="raw">The raw offset.</param>
    /// <param name="source">All drawn segments; null leaves the raw offset unchanged.</param>
    public static CoveredEnds TakenFrom(RawOffset raw, PieceTree? source)
    {
        var ends = new CoveredEnds(raw, source);
        if (source is not null && ends._radius > 0.0) ends.TakeAway();
        return ends;
    }

    private void TakeAway()
    {
        for (var i = 0; i < _pieces.Length; i++)
        {
            if (IsLoose(_pieces[i].Start, _pieceBefore)) Forwards(i);
            if (!_gone[i] && IsLoose(_pieces[i].End, _pieceBehind)) Backwards(i);
        }
    }

    /// <summary>True for an end of the raw offset, unless it continues at another node; false for an end created here.</summary>
    private bool IsLoose(int node, int[] pieces) => node < pieces.Length && pieces[node] < 0 && !_continues[node];

    /// <summary>Advances from a loose start over all pieces that are completely covered.</summary>
    private void Forwards(int piece)
    {
        while (piece >= 0 && !_gone[piece])
        {
            var (raw, from) = (_pieces[piece], Covered(_pieces[piece].Piece, _pieces[piece].Place));
            if (from < 1.0)
            {
                if (from > 0.0) Shorten(piece, from, 1.0);
                return;
            }

            Remove(piece);
            if (!IsLoose(raw.End, _pieceBefore)) return;
            piece = _pieceBehind[raw.End];
        }
    }

    private void Backwards(int piece)
    {
        while (piece >= 0 && !_gone[piece])
        {
            var (raw, behind) = (_pieces[piece], Covered(_pieces[piece].Piece.Reversed(), _pieces[piece].Place));
            if (behind < 1.0)
            {
                if (behind > 0.0) Shorten(piece, 0.0, 1.0 - behind);
                return;
            }

            Remove(piece);
            if (!IsLoose(raw.Start, _pieceBehind)) return;
            piece = _pieceBefore[raw.Start];
        }
    }

    private void Remove(int piece)
    {
        _gone[piece] = true;
        var raw = _pieces[piece];
        if (raw.Start < _pieceBehind.Length) _pieceBehind[raw.Start] = -1;
        if (raw.End < _pieceBefore.Length) _pieceBefore[raw.End] = -1;
    }

    private void Shorten(int piece, double from, double to)
    {
        var raw = _pieces[piece];
        var (start, end) = (from > 0.0 ? NewNode(raw.Piece.At(from)) : raw.Start, to < 1.0 ? NewNode(raw.Piece.At(to)) : raw.End);
        _pieces[piece] = raw with { Piece = raw.Piece.Part(from, _nodes[start], to, _nodes[end]), Start = start, End = end };
    }

    private int NewNode(Point2D place)
    {
        _nodes.Add(place);
        return _nodes.Count - 1;
    }

    /// <summary>The fraction up to which a piece is certainly covered from its start on: each point covers as far as it is too near, or as far as the line near
    /// it extends.</summary>
    private double Covered(in PathPiece piece, int place)
    {
        var at = CoveredByNeighbours(piece, place);
        for (var step = 0; step < MaxSteps && at < 1.0; step++)
        {
            var near = _radius;
            var source = _source!.NearestPiece(piece.At(at), ref near);
            if (source < 0) break;
            at = Math.Max(at + ((_radius - near) / piece.Length), PieceReach.CoveredFrom(piece, at, _source.Pieces[source], _radius));
            if (_radius - near < MinStep * _radius) break;
        }

        return Math.Min(at, 1.0);
    }

    private double CoveredByNeighbours(in PathPiece piece, int place)
    {
        var left = PiecePart.Whole;
        for (var step = -Neighbours; step <= Neighbours + 1 && !left.IsEmpty; step++)
        {
            if ((uint)(place + step) < (uint)_drawn.Count && step != 0) PieceReach.Clip(piece, _drawn[place + step], _radius, ref left);
        }

        return left.IsEmpty ? 1.0 : left.From;
    }
}
