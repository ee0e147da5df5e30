using Engraver.Core.Geometry;
using Engraver.Core.Sequencing;

namespace Engraver.Core.Verification;

/// <summary>Determines the part of a drawn segment that no move runs along. Between two places next to the same move, or next to two consecutive moves, the
/// segment is covered; between other places it is halved.</summary>
internal sealed class CutCover
{
    private const int StepsOfPiece = 8;
    private const int MaxHalvings = 40;

    private readonly IReadOnlyList<StrokeMove> _moves;
    private readonly SegmentIndex _index;
    private readonly BoxTree.Measure _measure;
    private int _last;

    public CutCover(IReadOnlyList<StrokeMove> moves)
    {
        _moves = moves;
        _index = new SegmentIndex([.. moves.Select(move => move.Segment)]);
        _measure = (move, place) => Distance(move, place);
    }

    /// <summary>Length that is farther than <paramref name="within"/> from every move, and its start.</summary>
    public (double Length, Point2D First) Missing(in Segment drawn, double within)
    {
        if (!drawn.IsFreeCurve) return MissingOfPiece(drawn, within);
        var (sum, first) = (0.0, drawn.Start);
        foreach (var piece in drawn.Curve.Pieces())
        {
            var (length, at) = MissingOfPiece(Segment.FromCurve(piece), within);
            if (length > 0.0 && sum == 0.0) first = at;
            sum += length;
        }

        return (sum, first);
    }

    private (double Length, Point2D First) MissingOfPiece(in Segment piece, double within)
    {
        var (sum, first) = (0.0, piece.Start);
        var before = MoveBeside(piece.Start, within);
        for (var step = 0; step < StepsOfPiece; step++)
        {
            var (from, to) = ((double)step / StepsOfPiece, (step + 1.0) / StepsOfPiece);
            var after = MoveBeside(PlaceAt(piece, to), within);
            var length = Uncovered(piece, from, before, to, after, within, MaxHalvings);
            if (length > 0.0 && sum == 0.0) first = PlaceAt(piece, before < 0 ? from : to);
            sum += length;
            before = after;
        }

        return (sum, first);
    }

    private double Uncovered(in Segment piece, double from, int before, double to, int after, double within, int halvings)
    {
        var (start, end) = (PlaceAt(piece, from), PlaceAt(piece, to));
        var length = start.DistanceTo(end);
        if (before < 0 && after < 0) return length;
        if (before >= 0 && after >= 0 && (length <= within || AreOne(before, start, after, end, within))) return 0.0;
        if (length <= within || halvings == 0) return length;
        var middle = (from + to) / 2.0;
        var beside = MoveBeside(PlaceAt(piece, middle), within);
        return Uncovered(piece, from, before, middle, beside, within, halvings - 1) + Uncovered(piece, middle, beside, to, after, within, halvings - 1);
    }

    private bool AreOne(int before, Point2D start, int after, Point2D end, double within) =>
        before == after || (Math.Abs(before - after) == 1 && AreJoined(Math.Min(before, after))) || IsBeside(before, end, within) || IsBeside(after, start, within);

    private bool AreJoined(int move) => _moves[move].Segment.End == _moves[move + 1].Segment.Start;

    /// <summary>The ends are stored; for a circle they are the same.</summary>
    private static Point2D PlaceAt(in Segment segment, double fraction) => fraction <= 0.0 ? segment.Start : fraction >= 1.0 ? segment.End : segment.PointAt(fraction);

    /// <summary>A move within this distance, -1 for none. Fast for queries along a path: the last result and the next move are tried first.</summary>
    private int MoveBeside(Point2D place, double within)
    {
        for (var move = _last; move < Math.Min(_last + 2, _moves.Count); move++)
        {
            if (IsBeside(move, place, within)) return _last = move;
        }

        var found = _index.NearestBy(_measure, place, within, 0.0, out _);
        return found < 0 ? -1 : _last = found;
    }

    private bool IsBeside(int move, Point2D place, double within) => Distance(move, place) <= within;

    /// <summary>The value without the share that rounding alone can cause.</summary>
    private double Distance(int move, Point2D place) => Math.Max(0.0, _moves[move].Segment.DistanceTo(place) - ToolpathTolerances.RoundingOf(_moves[move].Segment));
}
