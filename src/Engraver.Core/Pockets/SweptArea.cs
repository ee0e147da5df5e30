using Engraver.Core.Geometry;
using Engraver.Core.Offsets;
using Engraver.Core.Offsets.Pieces;

namespace Engraver.Core.Pockets;

/// <summary>The area that a round tool sweeps along chains of lines and arcs: the union of all its positions, computed from its boundary alone (Green's
/// theorem).</summary>
/// <remarks>Independent of the offset computation, so that it can verify it. Every piece is bounded by its two parallels and by circles about its ends; a part
/// of those belongs to the boundary when no piece is nearer to it than the radius. Parts that coincide count once when the tool is on the same side of them,
/// and not at all when it is on both sides.</remarks>
internal sealed class SweptArea
{
    /// <summary>Difference from the radius by which two boundaries still coincide, millimetres.</summary>
    private const double Coincident = 1e-9;

    private readonly SweptReach _reach;
    private readonly List<Segment> _border = [];
    private Vector2D _origin;
    private double _area;

    private SweptArea(IReadOnlyList<PathPiece> pieces, double radius) => _reach = new SweptReach(pieces, radius);

    /// <summary>Area, mm2.</summary>
    public double Area => _area;

    /// <summary>Its boundary, each part with the swept area on its left, in no particular order.</summary>
    public IReadOnlyList<Segment> Border => _border;

    /// <param name="chains">Each piece starts where the previous one ends; a closed chain ends at its start.</param>
    /// <param name="radius">Radius of the tool, above 0.</param>
    public static SweptArea Of(IReadOnlyList<IReadOnlyList<PathPiece>> chains, double radius)
    {
        List<PathPiece> pieces = [.. chains.SelectMany(chain => chain)];
        var swept = new SweptArea(pieces, radius);
        if (pieces.Count == 0) return swept;
        var box = pieces.Aggregate(Bounds2D.Empty, (all, piece) => all.Union(piece.Box()));
        swept._origin = new Vector2D((box.MinX + box.MaxX) / 2.0, (box.MinY + box.MaxY) / 2.0);
        var first = 0;
        foreach (var chain in chains)
        {
            swept.AddChain(chain, first);
            first += chain.Count;
        }

        return swept;
    }

    private void AddChain(IReadOnlyList<PathPiece> chain, int first)
    {
        for (var i = 0; i < chain.Count; i++)
        {
            var piece = chain[i];
            if (SweptReach.Parallel(piece, _reach.Radius) is { } left) AddBorder(left.Reversed(), first + i);
            if (SweptReach.Parallel(piece, -_reach.Radius) is { } right) AddBorder(right, first + i);
            if (piece.IsWholeTurn) continue;
            var next = i + 1 < chain.Count ? i + 1 : chain[^1].End == chain[0].Start ? 0 : -1;
            AddCap(piece.End, piece.EndTangent, next < 0 ? piece.EndTangent : chain[next].StartTangent, first + (next < 0 ? i : Math.Min(i, next)));
            if (i == 0 && chain[^1].End != piece.Start) AddCap(piece.Start, piece.StartTangent, piece.StartTangent, first);
        }
    }

    /// <summary>The circle about an end, in quarters from the points where it touches the parallels, so that these points are not in the middle of a
    /// part.</summary>
    private void AddCap(Point2D corner, Vector2D arriving, Vector2D leaving, int owner)
    {
        Span<double> turns = [Direction(arriving) + (Math.PI / 2.0), Direction(arriving) - (Math.PI / 2.0), Direction(leaving) + (Math.PI / 2.0), Direction(leaving) - (Math.PI / 2.0)];
        for (var i = 0; i < turns.Length; i++) turns[i] -= 2.0 * Math.PI * Math.Floor(turns[i] / (2.0 * Math.PI));
        turns.Sort();
        for (var i = 0; i < turns.Length; i++)
        {
            var sweep = (i + 1 < turns.Length ? turns[i + 1] : turns[0] + (2.0 * Math.PI)) - turns[i];
            if (sweep * _reach.Radius > Coincident) AddBorder(PathPiece.Arc(corner, _reach.Radius, turns[i], sweep, On(corner, turns[i]), On(corner, turns[i] + sweep)), owner);
        }
    }

    private Point2D On(Point2D centre, double turn) => centre + new Vector2D(_reach.Radius * Math.Cos(turn), _reach.Radius * Math.Sin(turn));

    private static double Direction(Vector2D tangent) => Math.Atan2(tangent.Y, tangent.X);

    private void AddBorder(PathPiece piece, int owner) => _reach.Divide(piece, (from, to, near) =>
    {
        if (!IsBorder(piece, from, to, near, owner)) return;
        var segment = piece.Part(from, piece.At(from), to, piece.At(to)).ToSegment();
        _border.Add(segment);
        _area += Sector(segment);
    });

    private bool IsBorder(in PathPiece piece, double from, double to, IReadOnlyList<int> near, int owner)
    {
        foreach (var share in (ReadOnlySpan<double>)[0.5, 0.29, 0.73])
        {
            if (_reach.Distance(piece.At(from + (share * (to - from))), near) < _reach.Radius - Coincident) return false;
        }

        var middle = from + (0.5 * (to - from));
        var place = piece.At(middle);
        var outwards = Outwards(piece, middle);
        for (var i = 0; i < near.Count; i++)
        {
            var other = _reach.Pieces[near[i]];
            if (near[i] == owner || other.DistanceTo(place) > _reach.Radius + Coincident) continue;
            var isSameSide = other.DistanceTo(place - (outwards * _reach.Radius)) < 0.5 * _reach.Radius;
            if (!isSameSide || near[i] < owner) return false;
        }

        return true;
    }

    /// <summary>Normal to the right of the direction of the boundary.</summary>
    private static Vector2D Outwards(in PathPiece piece, double fraction)
    {
        if (!piece.IsArc) return new Vector2D(piece.StartTangent.Y, -piece.StartTangent.X);
        var spoke = (piece.At(fraction) - piece.Centre) * (1.0 / piece.Radius);
        return piece.Sweep > 0.0 ? spoke : -spoke;
    }

    /// <summary>Area between the origin and a part of the border.</summary>
    private double Sector(in Segment segment)
    {
        var (start, end) = (segment.Start - _origin, segment.End - _origin);
        return (new Vector2D(start.X, start.Y).Cross(new Vector2D(end.X, end.Y)) / 2.0) + ChainArea.Of([segment]);
    }
}
