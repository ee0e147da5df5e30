using Engraver.Core.Geometry;
using Engraver.Core.Offsets.Pieces;

namespace Engraver.Core.Pockets;

/// <summary>The area within a distance of some pieces: the area that a round tool sweeps along them. Exact, from the circles and parallels that bound
/// it.</summary>
internal sealed class SweptReach
{
    /// <summary>Longest stretch that is evaluated at once, in radii: a longer stretch would have all pieces as neighbours.</summary>
    private const double StretchRadii = 8.0;

    /// <summary>Distance that counts as zero, millimetres.</summary>
    private const double Tolerance = 1e-10;

    private readonly PathPiece[] _pieces;
    private readonly BoxTree _tree;
    private readonly List<int> _near = [];
    private readonly List<double> _cuts = [];

    public SweptReach(IReadOnlyList<PathPiece> pieces, double radius)
    {
        _pieces = [.. pieces];
        Radius = radius;
        var boxes = new Bounds2D[_pieces.Length];
        for (var i = 0; i < boxes.Length; i++) boxes[i] = _pieces[i].Box();
        _tree = BoxTree.Build(boxes);
    }

    public double Radius { get; }

    public IReadOnlyList<PathPiece> Pieces => _pieces;

    /// <summary>Calls back with the fractions of every stretch of a piece between two places where it could enter or leave the reached area, and with the
    /// pieces near it.</summary>
    public void Divide(in PathPiece piece, Action<double, double, IReadOnlyList<int>> stretch)
    {
        var count = 1 + (int)(piece.Length / (StretchRadii * Radius));
        for (var i = 0; i < count; i++)
        {
            var (from, to) = ((double)i / count, (i + 1.0) / count);
            var part = piece.Part(from, i == 0 ? piece.Start : piece.At(from), to, i + 1 == count ? piece.End : piece.At(to));
            if (part.Length <= Tolerance) continue;
            FindCuts(part);
            var last = 0.0;
            foreach (var cut in _cuts)
            {
                if ((cut - last) * part.Length <= 4.0 * Tolerance) continue;
                stretch(from + (last * (to - from)), from + (cut * (to - from)), _near);
                last = cut;
            }
        }
    }

    /// <summary>Parts of a piece, as fractions, that are farther than the radius from every piece.</summary>
    public List<PiecePart> PartsOutside(in PathPiece piece)
    {
        var (parts, whole) = (new List<PiecePart>(), piece);
        Divide(piece, (from, to, near) =>
        {
            if (DistanceAt(whole, from, to, near) < Radius - Tolerance) return;
            if (parts is [.., var last] && last.To == from) parts[^1] = last with { To = to };
            else parts.Add(new PiecePart(from, to));
        });
        return parts;
    }

    /// <summary>The smallest distance at three points of a stretch: tangent points are often at the middle.</summary>
    private double DistanceAt(in PathPiece piece, double from, double to, IReadOnlyList<int> near)
    {
        var least = double.PositiveInfinity;
        foreach (var share in (ReadOnlySpan<double>)[0.5, 0.29, 0.73]) least = Math.Min(least, Distance(piece.At(from + (share * (to - from))), near));
        return least;
    }

    public double Distance(Point2D place, IReadOnlyList<int> among)
    {
        var least = double.PositiveInfinity;
        for (var i = 0; i < among.Count; i++) least = Math.Min(least, _pieces[among[i]].DistanceTo(place));
        return least;
    }

    /// <summary>Distance of the nearest piece.</summary>
    public double Distance(Point2D place)
    {
        _tree.Nearest(place, (item, from) => _pieces[item].DistanceTo(from), double.PositiveInfinity, out var distance);
        return distance;
    }

    private void FindCuts(in PathPiece part)
    {
        _near.Clear();
        _cuts.Clear();
        _tree.Overlapping(part.Box().Grown(Radius + (2.0 * Tolerance)), _near);
        foreach (var item in _near) AddCuts(part, _pieces[item]);
        _cuts.Add(1.0);
        _cuts.Sort();
    }

    private void AddCuts(in PathPiece part, in PathPiece piece)
    {
        AddCrossings(part, Circle(piece.Start));
        if (piece.End != piece.Start) AddCrossings(part, Circle(piece.End));
        if (Parallel(piece, Radius) is { } left) AddCrossings(part, left);
        if (Parallel(piece, -Radius) is { } right) AddCrossings(part, right);
    }

    private PathPiece Circle(Point2D centre) => CircleAbout(centre, Radius);

    private void AddCrossings(in PathPiece part, in PathPiece border)
    {
        Span<Crossing> found = stackalloc Crossing[PieceCrossings.MaxCount];
        var count = PieceCrossings.Between(part, border, Tolerance, found);
        for (var i = 0; i < count; i++)
        {
            if (found[i].OnFirst is > 0.0 and < 1.0) _cuts.Add(found[i].OnFirst);
        }
    }

    public static PathPiece CircleAbout(Point2D centre, double radius)
    {
        var start = centre + new Vector2D(radius, 0.0);
        return PathPiece.Arc(centre, radius, 0.0, 2.0 * Math.PI, start, start);
    }

    /// <summary>The piece moved to its left (right where negative); null for an arc that shrinks to nothing.</summary>
    public static PathPiece? Parallel(in PathPiece piece, double left)
    {
        var (start, end) = (piece.Start + (Left(piece.StartTangent) * left), piece.End + (Left(piece.EndTangent) * left));
        if (!piece.IsArc) return PathPiece.Line(start, end);
        var radius = piece.Radius - (Math.Sign(piece.Sweep) * left);
        return radius <= Tolerance ? null : PathPiece.Arc(piece.Centre, radius, piece.From, piece.Sweep, start, piece.IsWholeTurn ? start : end);
    }

    private static Vector2D Left(Vector2D tangent) => new(-tangent.Y, tangent.X);
}
