using Engraver.Core.Geometry;
using Engraver.Core.Offsets.Pieces;

namespace Engraver.Core.Offsets;

/// <summary>Side of a drawn contour on which a piece of its raw offset is; both sides where a contour covers itself.</summary>
[Flags]
internal enum RawSides : byte
{
    None = 0,
    Left = 1,
    Right = 2,

    /// <summary>Around the end of an open contour: it trims other pieces but is not part of an offset.</summary>
    Cap = 4,
}

/// <summary>A piece of the raw offset, with its start and end nodes.</summary>
/// <param name="Place">Number among <see cref="RawOffset.Drawn"/> of the piece that it is parallel to, or that ends at the corner.</param>
/// <param name="Source">The source segment, or the segment that it joins to the next one.</param>
internal readonly record struct RawPiece(PathPiece Piece, int Start, int End, RawSides Side, int Place, OffsetSource Source);

/// <summary>The raw offset to the left of closed chains: every piece shifted, corners joined on their outside and trimmed on their inside. It still crosses
/// itself; the parts that remain later are at least the distance away from all drawn segments.</summary>
/// <remarks>
/// The drawn segments are always on the right of a raw piece, the free area is on its left. On the inside of a corner whose pieces are too short to meet, and
/// where an arc is smaller than the distance, the chain is interrupted: its ends there are nearer to the drawing than the distance, and the parts connected to
/// them do not belong to the result.
/// </remarks>
internal sealed class RawOffset(double distance, OffsetOptions options, double tolerance)
{
    private readonly List<RawPiece> _pieces = [];
    private readonly List<PathPiece> _drawn = [];
    private readonly List<Point2D> _nodes = [];
    private readonly List<(int One, int Other)> _same = [];

    public double Distance => distance;

    /// <summary>The pieces of all chains, one after the other.</summary>
    public IReadOnlyList<PathPiece> Drawn => _drawn;

    public double Tolerance => tolerance;

    /// <summary>Millimetres by which a piece may be nearer to the drawn segments because a joint that is meant to be smooth has one node.</summary>
    public double Smoothness { get; private set; }

    public IReadOnlyList<RawPiece> Pieces => _pieces;

    /// <summary>Start and end points of pieces, by their numbers.</summary>
    public IReadOnlyList<Point2D> Nodes => _nodes;

    /// <summary>Nodes that are merged because the piece between them has no length.</summary>
    public IReadOnlyList<(int One, int Other)> Same => _same;

    /// <summary>Adds the left side of a chain.</summary>
    public void Add(RawChain chain)
    {
        var pieces = chain.Pieces;
        Reserve(pieces.Length);
        Smoothness = Math.Max(Smoothness, chain.Smoothness);
        var shifted = new ShiftedPiece[pieces.Length];
        for (var i = 0; i < pieces.Length; i++) shifted[i] = ShiftedPiece.LeftOf(pieces[i], distance, tolerance);
        var joins = new (int From, int To)[pieces.Length];
        for (var i = 0; i < pieces.Length; i++)
        {
            var next = i + 1 == pieces.Length ? 0 : i + 1;
            JoinEnds(ref shifted[i], ref shifted[next], pieces[i], pieces[next], chain.Smoothness, chain.IsCapBehind(i), out joins[i]);
        }

        for (var i = 0; i < pieces.Length; i++)
        {
            _drawn.Add(pieces[i]);
            var (side, source, join) = (chain.SideOf(i), chain.Sources[i], chain.Sources[i] with { IsJoin = true });
            AddTip(shifted[i].TipAhead, shifted[i].StartNode, side, join);
            AddPiece(shifted[i], side, source);
            AddTip(shifted[i].EndNode, shifted[i].TipBehind, side, join);
            if (joins[i].To >= 0) AddJoin(pieces[i], pieces[i + 1 == pieces.Length ? 0 : i + 1], joins[i], chain.IsCapBehind(i) ? RawSides.Cap : side, join);
        }
    }

    /// <summary>Room for a chain: each piece with one join, and a node at each of its ends.</summary>
    private void Reserve(int count)
    {
        _pieces.EnsureCapacity(_pieces.Count + (2 * count));
        _drawn.EnsureCapacity(_drawn.Count + count);
        _nodes.EnsureCapacity(_nodes.Count + (2 * count));
    }

    private int NewNode(Point2D place)
    {
        _nodes.Add(place);
        return _nodes.Count - 1;
    }

    /// <summary>Decides what is between two neighbours: a common node, a trimmed corner, a gap, or two nodes with a join between them.</summary>
    private void JoinEnds(ref ShiftedPiece before, ref ShiftedPiece after, in PathPiece source, in PathPiece next, double smoothness, bool isCap, out (int From, int To) join)
    {
        join = (-1, -1);
        var (leaving, arriving, corner) = (source.EndTangent, next.StartTangent, source.End);
        var (sin, cos) = (leaving.Cross(arriving), leaving.Dot(arriving));
        if (cos > 0.0 && distance * sin * sin <= 8.0 * smoothness)
        {
            var normal = Left(leaving) + Left(arriving);
            before.EndNode = after.StartNode = NewNode(corner + (normal * (distance / PathPiece.Norm(normal))));
            return;
        }

        if (sin > 0.0 && Trim(ref before, ref after, source, next, sin, cos)) return;
        before.EndNode = NewNode(corner + (Left(leaving) * distance));
        after.StartNode = NewNode(corner + (Left(arriving) * distance));
        if (sin > 0.0) return;
        if (!isCap && OffsetCorner.Mitre(corner, leaving, arriving, distance, options) is { } tip) JoinInTip(ref before, ref after, source, next, tip);
        else join = (before.EndNode, after.StartNode);
    }

    /// <summary>Lines are extended to the tip; after or before an arc the join has a separate line.</summary>
    private void JoinInTip(ref ShiftedPiece before, ref ShiftedPiece after, in PathPiece source, in PathPiece next, Point2D tip)
    {
        var node = NewNode(tip);
        if (source.IsArc) before.TipBehind = node;
        else before.EndNode = node;
        if (next.IsArc) after.TipAhead = node;
        else after.StartNode = node;
    }

    /// <summary>On the inside of a corner: both pieces end where they meet. The part that is cut off is nearer to the other piece than the distance.</summary>
    private bool Trim(ref ShiftedPiece before, ref ShiftedPiece after, in PathPiece source, in PathPiece next, double sin, double cos)
    {
        if (!before.Exists || !after.Exists) return false;
        if (!source.IsArc && !next.IsArc)
        {
            var setback = cos > 0.0 ? distance * sin / (1.0 + cos) : distance * (1.0 - cos) / sin; // the same, without a difference of nearly equal numbers
            if (!(setback <= source.Length && setback <= next.Length)) return false;
            var meeting = source.End + (Left(source.EndTangent) * distance) - (source.EndTangent * setback);
            TrimAt(ref before, ref after, meeting, 1.0 - (setback / source.Length), setback / next.Length);
            return true;
        }

        Span<Crossing> found = stackalloc Crossing[PieceCrossings.MaxCount];
        if (PieceCrossings.Between(before.Piece, after.Piece, tolerance, found) != 1) return false;
        var (place, to, from) = found[0];
        if (!IsCovered(before.Piece, to, 1.0, next) || !IsCovered(after.Piece, 0.0, from, source)) return false;
        TrimAt(ref before, ref after, place, to, from);
        return true;
    }

    /// <summary>True when the middle and the outer end of the part that is cut off are nearer to the other source piece than the distance.</summary>
    private bool IsCovered(in PathPiece piece, double from, double to, in PathPiece other)
    {
        var outer = from == 0.0 ? piece.Start : piece.End;
        return other.DistanceTo(piece.At((from + to) / 2.0)) < distance + tolerance && other.DistanceTo(outer) < distance + tolerance;
    }

    private void TrimAt(ref ShiftedPiece before, ref ShiftedPiece after, Point2D place, double to, double from)
    {
        before.EndNode = after.StartNode = NewNode(place);
        before.To = to;
        after.From = from;
    }

    private void AddPiece(in ShiftedPiece shifted, RawSides side, OffsetSource source)
    {
        if (shifted.IsPoint) _same.Add((shifted.StartNode, shifted.EndNode));
        if (!shifted.Exists) return;
        var (start, end) = (_nodes[shifted.StartNode], _nodes[shifted.EndNode]);
        if (shifted.From >= shifted.To || !shifted.KeepsDirection(start, end))
        {
            if (start.IsNear(end, tolerance) && !shifted.Piece.IsWholeTurn) _same.Add((shifted.StartNode, shifted.EndNode));
            return;
        }

        _pieces.Add(new RawPiece(shifted.Trimmed(start, end), shifted.StartNode, shifted.EndNode, side, _drawn.Count - 1, source));
    }

    /// <summary>The line between an arc and the tip of its mitre.</summary>
    private void AddTip(int from, int to, RawSides side, OffsetSource source)
    {
        if (from >= 0 && to >= 0) _pieces.Add(new RawPiece(PathPiece.Line(_nodes[from], _nodes[to]), from, to, side, _drawn.Count - 1, source));
    }

    private void AddJoin(in PathPiece source, in PathPiece next, (int From, int To) join, RawSides side, OffsetSource origin)
    {
        var (leaving, arriving, corner) = (source.EndTangent, next.StartTangent, source.End);
        var (start, end) = (_nodes[join.From], _nodes[join.To]);
        if (options.Join == OffsetJoin.Round || side == RawSides.Cap)
        {
            var turn = -Math.Abs(Math.Atan2(leaving.Cross(arriving), leaving.Dot(arriving)));
            var outward = Left(leaving);
            _pieces.Add(new RawPiece(PathPiece.Arc(corner, distance, Math.Atan2(outward.Y, outward.X), turn, start, end), join.From, join.To, side, _drawn.Count - 1, origin));
        }
        else
        {
            _pieces.Add(new RawPiece(PathPiece.Line(start, end), join.From, join.To, side, _drawn.Count - 1, origin));
        }
    }

    private static Vector2D Left(Vector2D tangent) => new(-tangent.Y, tangent.X);
}
