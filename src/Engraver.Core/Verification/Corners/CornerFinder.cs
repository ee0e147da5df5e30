using Engraver.Core.Geometry;

namespace Engraver.Core.Verification.Corners;

/// <summary>Finds the corners of a drawing: every pair of ends that can be joined, with a turn. Of many ends in one place only those pairs count whose regions
/// contain the others.</summary>
/// <remarks>For an end, the region grows with the angle between the sides as long as the sides are long enough for the largest arc, and then shrinks. So of
/// many ends in one place, the two next to that angle are enough; number and time grow with the number of ends and not with its square.</remarks>
internal sealed class CornerFinder
{
    /// <summary>Of so many ends in one place or fewer, all pairs are corners.</summary>
    private const int FewEnds = 12;

    /// <summary>Ends with too short pieces that are tried before the search ends.</summary>
    private const int MaxTried = 6;

    /// <summary>Part of the largest useful length of a piece from which the search ends.</summary>
    private const double LongEnough = 0.9;

    /// <summary>An arc of a smaller radius, counts, is the corner itself.</summary>
    private const double MinRadius = 0.25;

    /// <summary>Turn of less than this, radians, is rounding.</summary>
    private const double MinTurn = 1e-9;

    /// <summary>Turn between two pieces of a curve, radians, below which the curve is smooth.</summary>
    private const double Smooth = 1e-6;

    /// <summary>Longest part of an arc that is used as a side, radians.</summary>
    private const double MaxSweep = 1.4;

    private readonly Segment[] _pieces;
    private readonly TraceTolerances _tolerances;
    private readonly List<(int One, int Other)> _corners = [];
    private readonly List<OrientedBox> _boxes = [];
    private readonly List<(int Piece, int Corner)> _places = [];

    private CornerFinder(Segment[] pieces, TraceTolerances tolerances) => (_pieces, _tolerances) = (pieces, tolerances);

    /// <summary>Boxes around the regions of all corners.</summary>
    public OrientedBox[] Boxes => [.. _boxes];

    /// <summary>The pieces at which each corner is to be considered.</summary>
    public IReadOnlyList<(int Piece, int Corner)> Places => _places;

    /// <summary>Finds all corners.</summary>
    /// <param name="pieces">Ellipses and splines as their pieces.</param>
    /// <param name="heightOf">The height of a piece at its start (true) or end; null where heights do not count.</param>
    public static CornerFinder Find(Segment[] pieces, TraceTolerances tolerances, Func<int, bool, double>? heightOf)
    {
        var finder = new CornerFinder(pieces, tolerances);
        if (tolerances.CornerTolerance <= 0.0) return finder;
        var groups = new EndGroups(PieceEnd.AllOf(pieces, heightOf));
        foreach (var group in groups.OfSeveral()) finder.AddPairs(group, group);
        foreach (var (one, other) in groups.Near(finder.Joint)) finder.AddPairs(one, other);
        return finder;
    }

    /// <summary>Creates a corner that was found: a drawing can have too many to keep them all.</summary>
    public DrawnCorner Create(int corner)
    {
        var (one, other) = _corners[corner];
        return Create(PieceEnd.Of(_pieces, one / 2, one % 2 == 0), PieceEnd.Of(_pieces, other / 2, other % 2 == 0))!;
    }

    /// <summary>Ends within this distance can be joined, or have only a part between them that is too short to be cut.</summary>
    private double Joint => Math.Max(_tolerances.JoinTolerance, _tolerances.Deviation);

    private void AddPairs(EndGroup one, EndGroup other)
    {
        if (one.Ends.Length + (one == other ? 0 : other.Ends.Length) > FewEnds)
        {
            foreach (var end in one.Ends) AddBest(end, other);
            foreach (var end in one == other ? [] : other.Ends) AddBest(end, one);
            return;
        }

        var first = _corners.Count;
        for (var i = 0; i < one.Ends.Length; i++)
        {
            for (var k = one == other ? i + 1 : 0; k < other.Ends.Length; k++) Add(one.Ends[i], other.Ends[k]);
        }

        int[] around = [.. one.Ends.Concat(one == other ? [] : other.Ends).Select(end => end.Piece).Distinct()];
        for (var corner = first; corner < _corners.Count; corner++) _places.AddRange(around.Select(piece => (piece, corner)));
    }

    /// <summary>The pairs of an end with those of many others whose regions contain the other regions.</summary>
    private void AddBest(in PieceEnd end, EndGroup others)
    {
        // The angle at which the largest arc needs the whole piece.
        var whole = Math.PI - (4.0 * Math.Atan(_tolerances.CornerTolerance / _pieces[end.Piece].Length));
        var direction = Math.Atan2(end.Along.Y, end.Along.X);
        foreach (var side in (ReadOnlySpan<double>)[1.0, -1.0])
        {
            AddUntilLong(end, side, others.From(direction + (side * whole), isRising: true));
            AddUntilLong(end, side, others.From(direction + (side * whole), isRising: false));
        }
    }

    /// <summary>Adds the pairs of an end with the next ends until a piece is long enough for the largest arc.</summary>
    /// <param name="side">1 for ends to the left, -1 for ends to the right.</param>
    private void AddUntilLong(in PieceEnd end, double side, IEnumerable<PieceEnd> others)
    {
        var tried = 0;
        foreach (var other in others)
        {
            var angle = side * end.LeftTurnTo(other);
            if (!(angle > 0.0 && angle < Math.PI) || tried++ == MaxTried) return;
            if (Add(end, other)) _places.Add((end.Piece, _corners.Count - 1));
            if (_pieces[other.Piece].Length >= LongEnough * Math.Min(_pieces[end.Piece].Length, LongestContact(Math.PI - angle))) return;
        }
    }

    /// <summary>Length on each of two straight sides up to the largest arc.</summary>
    /// <param name="turn">Radians.</param>
    private double LongestContact(double turn) => _tolerances.CornerTolerance / Math.Tan(turn / 4.0);

    /// <summary>Adds a corner unless its region is too small to matter.</summary>
    /// <returns>False when it was not added.</returns>
    private bool Add(in PieceEnd one, in PieceEnd other)
    {
        if (Create(one, other) is not { } corner) return false;
        _corners.Add((Code(one), Code(other)));
        _boxes.Add(corner.Box());
        return true;
    }

    private static int Code(in PieceEnd end) => (2 * end.Piece) + (end.IsStart ? 0 : 1);

    /// <summary>The corner of two ends; null when its region is too small to matter.</summary>
    private DrawnCorner? Create(in PieceEnd one, in PieceEnd other)
    {
        var left = one.LeftTurnTo(other);
        if (left < 0.0) return Create(other, one);
        var turn = Math.PI - left;
        var gap = one.Place.DistanceTo(other.Place);
        if (one.Piece == other.Piece && (one.IsStart == other.IsStart || _pieces[one.Piece].Length <= 2.0 * Joint)) return null;
        if (turn < MinTurn || left < MinTurn) return null;
        var most = LongestContact(turn);
        var (pieces, piecesOther) = (PiecesOf(one, most, out var length), PiecesOf(other, most, out var lengthOther));
        var contact = Math.Min(most, Math.Min(length, lengthOther));
        if (contact * Math.Tan(turn / 4.0) < _tolerances.Count / 10.0 || contact * Math.Tan(left / 2.0) < MinRadius * _tolerances.Count) return null;
        var (firstMisfit, secondMisfit) = (0.0, 0.0);
        var first = SideOf(one, pieces, isInwardLeft: true, ref length, most, ref firstMisfit);
        var second = SideOf(other, piecesOther, isInwardLeft: false, ref lengthOther, most, ref secondMisfit);
        var circle = TangentCircle.Largest(first, second, _tolerances.CornerTolerance, length, lengthOther);
        if (!(circle.Radius > 0.0)) return null;
        var apex = one.Place + ((other.Place - one.Place) * 0.5);
        return new DrawnCorner(apex, first, second, circle, (gap / 2.0) + Math.Max(firstMisfit, secondMisfit));
    }

    /// <summary>The piece of an end, of a curve also the next ones up to a length: where they continue smoothly.</summary>
    /// <param name="most">Length of interest, millimetres.</param>
    /// <param name="length">Their length, or more than <paramref name="most"/>.</param>
    private int[] PiecesOf(in PieceEnd end, double most, out double length)
    {
        length = _pieces[end.Piece].Length;
        if (!_pieces[end.Piece].IsFreeCurve || length >= most) return [end.Piece];
        var (pieces, step) = (new List<int> { end.Piece }, end.IsStart ? 1 : -1);
        for (var next = end.Piece + step; length < most && next >= 0 && next < _pieces.Length && Continues(next - step, next, step); next += step)
        {
            pieces.Add(next);
            length += _pieces[next].Length;
        }

        return [.. pieces];
    }

    private bool Continues(int piece, int next, int step)
    {
        var (before, after) = step > 0 ? (_pieces[piece], _pieces[next]) : (_pieces[next], _pieces[piece]);
        if (!before.IsFreeCurve || !after.IsFreeCurve || before.End != after.Start) return false;
        return before.EndTangent.Dot(after.StartTangent) > 0.0 && Math.Abs(before.EndTangent.Cross(after.StartTangent)) < Smooth;
    }

    /// <param name="length">In: the length of the pieces. Out: the length that can be a side.</param>
    /// <param name="misfit">Receives the distance of the pieces from the side.</param>
    private DrawnSide SideOf(in PieceEnd end, int[] pieces, bool isInwardLeft, ref double length, double most, ref double misfit)
    {
        var inward = isInwardLeft ? new Vector2D(-end.Along.Y, end.Along.X) : new Vector2D(end.Along.Y, -end.Along.X);
        length = Math.Min(length, most);
        var line = new DrawnSide(end.Along, inward, 0.0, pieces, end.IsStart);
        ref readonly var piece = ref _pieces[end.Piece];
        if (piece.Kind == SegmentKind.Line) return line;
        var curvature = piece.IsFreeCurve
            ? CurvatureOf(end, PlaceAt(pieces, end.IsStart, length), inward)
            : (IsLeftBend(piece, end.IsStart) == isInwardLeft ? 1.0 : -1.0) / piece.Arc.Radius;
        length = Math.Min(length, MaxSweep / Math.Abs(curvature));
        var isStraight = Math.Abs(curvature) * length * length / 2.0 < _tolerances.Count / 100.0;
        var side = isStraight ? line : line with { Curvature = curvature };
        if (isStraight) misfit = Math.Abs(curvature) * length * length / 2.0;
        if (piece.IsFreeCurve)
        {
            var (half, whole) = (PlaceAt(pieces, end.IsStart, length / 2.0) - end.Place, PlaceAt(pieces, end.IsStart, length) - end.Place);
            misfit = Math.Max(Math.Abs(side.Inside(half)), Math.Abs(side.Inside(whole)));
        }

        return side;
    }

    private static bool IsLeftBend(in Segment arc, bool isFromStart) => isFromStart == arc.Arc.Sweep.Degrees > 0.0;

    /// <summary>Curvature of the arc that leaves an end in its direction and reaches a place; positive when it bends inward.</summary>
    private static double CurvatureOf(in PieceEnd end, Point2D place, Vector2D inward)
    {
        var chord = place - end.Place;
        return chord.LengthSquared > 0.0 ? 2.0 * chord.Dot(inward) / chord.LengthSquared : 0.0;
    }

    /// <summary>The place on the pieces of a curve at about this length from their first end.</summary>
    private Point2D PlaceAt(int[] pieces, bool isFromStart, double length)
    {
        foreach (var piece in pieces)
        {
            var own = _pieces[piece].Length;
            if (length > own && piece != pieces[^1])
            {
                length -= own;
                continue;
            }

            var fraction = own > 0.0 ? Math.Min(1.0, length / own) : 1.0;
            return _pieces[piece].PointAt(isFromStart ? fraction : 1.0 - fraction);
        }

        return default;
    }
}
