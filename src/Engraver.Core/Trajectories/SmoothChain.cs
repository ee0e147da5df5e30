using Engraver.Core.Geometry;

namespace Engraver.Core.Trajectories;

/// <summary>Pieces joined end to start that one trajectory follows: the part between two corners of a contour, a whole contour without corners, or a contour
/// with its corners as joints.</summary>
internal sealed class SmoothChain
{
    private readonly ChainPiece[] _pieces;

    private SmoothChain(ChainPiece[] pieces, bool closed)
    {
        (_pieces, Closed) = (pieces, closed);
        Joints = FindJoints();
    }

    public IReadOnlyList<ChainPiece> Pieces => _pieces;

    /// <summary>True when the end is the start; the spline is then periodic.</summary>
    public bool Closed { get; }

    public double Length => _pieces[^1].End;

    /// <summary>Joints where curvature or direction jumps, in order of length; for a closed chain also at 0.</summary>
    public IReadOnlyList<ChainJoint> Joints { get; }

    /// <param name="segments">Segments, at least one with a length, joined end to start.</param>
    /// <param name="closed">True when the last segment ends where the first starts.</param>
    public static SmoothChain From(IEnumerable<Segment> segments, bool closed)
    {
        var pieces = new List<ChainPiece>();
        foreach (var segment in segments) pieces.AddRange(ChainPiece.Of(segment, pieces.Count == 0 ? 0.0 : pieces[^1].End));
        if (pieces.Count == 0) throw new ArgumentException("A chain needs a segment with a length.", nameof(segments));
        return new SmoothChain([.. pieces], closed);
    }

    /// <summary>The piece at a length; at a joint the piece that starts there.</summary>
    public int PieceAt(double length)
    {
        var (low, high) = (0, _pieces.Length - 1);
        while (low < high)
        {
            var middle = (low + high + 1) / 2;
            if (_pieces[middle].Start <= length) low = middle;
            else high = middle - 1;
        }

        return low;
    }

    public ChainPoint At(double length)
    {
        length = Wrapped(length);
        var piece = _pieces[PieceAt(length)];
        return piece.At(piece.FractionAt(length));
    }

    /// <summary>The place at a length by quadrature (<see cref="ChainPiece.ArcLengthAt"/>), and the same place as a length for <see cref="At"/>.</summary>
    public (ChainPoint Place, double At) AtArcLength(double length)
    {
        length = Wrapped(length);
        var piece = _pieces[PieceAt(length)];
        var fraction = piece.FractionAtArcLength(length);
        return (piece.At(fraction), piece.LengthAt(fraction));
    }

    /// <summary>The length within 0 and <see cref="Length"/>; for an open chain, a length beyond an end gives the end.</summary>
    public double Wrapped(double length)
    {
        if (!Closed) return Math.Clamp(length, 0.0, Length);
        length %= Length;
        return length < 0.0 ? length + Length : length;
    }

    /// <summary>The place nearest to a point, searched from an initial guess of the length: its signed distance (left positive) and the direction of travel
    /// there.</summary>
    /// <param name="near">Accuracy of the search, as a fraction of a piece.</param>
    public (double Distance, Vector2D Tangent) Beside(Point2D point, double guess, double near = 1e-6)
    {
        guess = Wrapped(guess);
        var index = PieceAt(guess);
        var (fraction, came) = (_pieces[index].FractionAt(guess), 0);
        for (var step = 0; step < _pieces.Length + 2; step++)
        {
            var foot = _pieces[index].Foot(point, fraction, near);
            var way = foot < 0.0 ? -1 : foot > 1.0 ? 1 : 0;
            var next = index + way;
            if (Closed) next = (next + _pieces.Length) % _pieces.Length;
            if (way == 0 || came == -way || next < 0 || next >= _pieces.Length)
            {
                return Signed(point, _pieces[index].Near(Math.Clamp(foot, 0.0, 1.0)), way != 0);
            }

            (index, fraction, came) = (next, way > 0 ? 0.0 : 1.0, way);
        }

        return Signed(point, _pieces[index].Near(fraction), isEnd: true);
    }

    private static (double Distance, Vector2D Tangent) Signed(Point2D point, (Point2D Point, Vector2D Tangent) place, bool isEnd)
    {
        var across = place.Tangent.Cross(point - place.Point);
        return (isEnd ? Math.CopySign(place.Point.DistanceTo(point), across) : across, place.Tangent);
    }

    private List<ChainJoint> FindJoints()
    {
        var joints = new List<ChainJoint>();
        for (var i = Closed ? 0 : 1; i < _pieces.Length; i++)
        {
            var (before, after) = (_pieces[(i + _pieces.Length - 1) % _pieces.Length].At(1.0), _pieces[i].At(0.0));
            var turn = before.Tangent.TurnTo(after.Tangent);
            joints.Add(new ChainJoint(_pieces[i].Start, after.Curvature - before.Curvature, turn));
        }

        return joints;
    }
}

/// <summary>A joint of two pieces.</summary>
/// <param name="At">Length from the start of the chain.</param>
/// <param name="CurvatureJump">Jump of the curvature, 1/mm.</param>
/// <param name="Turn">Signed turn; near 0 when the pieces are tangent.</param>
internal readonly record struct ChainJoint(double At, double CurvatureJump, Angle Turn)
{
    /// <summary>Larger turns are corners (sace-xps-agie.md 3.5 step 0).</summary>
    public const double CornerDegrees = 0.05;

    public bool IsCorner => Turn.Abs().Degrees > CornerDegrees;
}
