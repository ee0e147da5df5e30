using Engraver.Core.Geometry;
using Engraver.Core.Offsets.Pieces;

namespace Engraver.Core.Pockets;

/// <summary>A pass as it is planned: a closed loop with the pocket on its left, or an open run.</summary>
internal sealed class PassChain
{
    /// <summary>Millimetres from the end of a piece within which a point on it counts as that end: shorter moves are ignored.</summary>
    public const double Joint = 1e-6;

    private BoxTree? _tree;

    public PassChain(PathPiece[] pieces, bool closed, PassKind kind, int level)
    {
        (Pieces, Closed, Kind, Level) = (pieces, closed, kind, level);
        Along = new double[pieces.Length + 1];
        for (var i = 0; i < pieces.Length; i++) Along[i + 1] = Along[i] + pieces[i].Length;
    }

    public PathPiece[] Pieces { get; }

    public bool Closed { get; }

    public PassKind Kind { get; }

    public int Level { get; }

    /// <summary>Length up to the start of each piece, and total length.</summary>
    public double[] Along { get; }

    public double Length => Along[^1];

    public PassPlace Start => new(0, 0.0, Pieces[0].Start, 0.0);

    public PassPlace End => new(Pieces.Length - 1, 1.0, Pieces[^1].End, Length);

    /// <summary>The middle of the longest piece: far from corners.</summary>
    public PassPlace Middle
    {
        get
        {
            var longest = 0;
            for (var i = 1; i < Pieces.Length; i++) longest = Pieces[i].Length > Pieces[longest].Length ? i : longest;
            return At(longest, 0.5);
        }
    }

    public PassPlace At(int piece, double fraction) => new(piece, fraction, fraction == 0.0 ? Pieces[piece].Start : fraction == 1.0 ? Pieces[piece].End : Pieces[piece].At(fraction), Along[piece] + (fraction * Pieces[piece].Length));

    /// <summary>The point of the pass that is nearest to a given point.</summary>
    public PassPlace Nearest(Point2D place)
    {
        _tree ??= BoxTree.Build([.. Pieces.Select(piece => piece.Box())]);
        var nearest = _tree.Nearest(place, (item, from) => Pieces[item].DistanceTo(from), double.PositiveInfinity, out _);
        return NearestOn(nearest, place);
    }

    public PassPlace NearestOn(int piece, Point2D place)
    {
        var fraction = Math.Clamp(Pieces[piece].FractionOf(place), 0.0, 1.0);
        var length = Pieces[piece].Length;
        return At(piece, fraction * length < Joint ? 0.0 : (1.0 - fraction) * length < Joint ? 1.0 : fraction);
    }

    /// <summary>Adds the pieces from one place forwards to another; on a closed pass, a place at or before the first means one full round.</summary>
    public void AddForwards(PassPlace from, PassPlace to, List<PathPiece> pieces)
    {
        if (from.Along < to.Along)
        {
            AddStraight(from, to, pieces);
            return;
        }

        AddStraight(from, End, pieces);
        AddStraight(Start, to, pieces);
    }

    /// <summary>Adds the shorter path around a closed pass, or the path along an open one.</summary>
    public void AddShorter(PassPlace from, PassPlace to, List<PathPiece> pieces)
    {
        var ahead = to.Along - from.Along;
        if (Closed && ahead < 0.0) ahead += Length;
        if (ahead == 0.0) return;
        if (ahead > 0.0 && (!Closed || ahead <= Length / 2.0))
        {
            AddForwards(from, to, pieces);
            return;
        }

        var back = new List<PathPiece>();
        AddForwards(to, from, back);
        for (var i = back.Count - 1; i >= 0; i--) pieces.Add(back[i].Reversed());
    }

    /// <summary>Length of the path that <see cref="AddShorter"/> takes.</summary>
    public double ShorterLength(PassPlace from, PassPlace to)
    {
        var way = Math.Abs(to.Along - from.Along);
        return Closed ? Math.Min(way, Length - way) : way;
    }

    public PassChain Reversed()
    {
        var pieces = new PathPiece[Pieces.Length];
        for (var i = 0; i < pieces.Length; i++) pieces[i] = Pieces[^(i + 1)].Reversed();
        return new PassChain(pieces, Closed, Kind, Level);
    }

    private void AddStraight(PassPlace from, PassPlace to, List<PathPiece> pieces)
    {
        for (var i = from.Piece; i <= to.Piece; i++)
        {
            var (first, last) = (i == from.Piece ? from.Fraction : 0.0, i == to.Piece ? to.Fraction : 1.0);
            if (last <= first) continue;
            var piece = Pieces[i];
            pieces.Add(first == 0.0 && last == 1.0 ? piece : piece.Part(first, first == 0.0 ? piece.Start : from.Place, last, last == 1.0 ? piece.End : to.Place));
        }
    }
}

/// <summary>A place on a pass.</summary>
/// <param name="Piece">Number of the piece.</param>
/// <param name="Fraction">Fraction of its length.</param>
/// <param name="Place">The point.</param>
/// <param name="Along">Length from the start of the pass.</param>
internal readonly record struct PassPlace(int Piece, double Fraction, Point2D Place, double Along);
