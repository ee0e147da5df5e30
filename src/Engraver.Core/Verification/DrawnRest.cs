using Engraver.Core.Geometry;
using Engraver.Core.Sequencing;

namespace Engraver.Core.Verification;

/// <summary>Answers how far a move lies from the rows that it may stand for: those of its entity, and, when arcs were recovered, an arc for any line.</summary>
internal sealed class DrawnRest
{
    /// <summary>Places of a move that are looked at, both ends among them.</summary>
    private const int Places = 9;

    private readonly List<StrokeMove> _pieces = [];
    private readonly List<double> _allowed = [];
    private readonly HashSet<int> _entities;
    private readonly bool _arcsRecovered;
    private readonly SegmentIndex _index;
    private readonly BoxTree.Measure _measure;
    private StrokeMove _move;
    private int _last;

    /// <param name="rows">Not paired with a move.</param>
    public DrawnRest(IReadOnlyList<StrokeMove> rows, ToolpathTolerances tolerances)
    {
        foreach (var row in rows)
        {
            var allowed = tolerances.For(row.Segment);
            foreach (var piece in CurvePieces.Split([row.Segment]))
            {
                _pieces.Add(new StrokeMove(piece, row.EntityIndex));
                _allowed.Add(allowed);
            }
        }

        _entities = [.. rows.Select(row => row.EntityIndex)];
        _arcsRecovered = tolerances.ArcsRecovered;
        _index = new SegmentIndex([.. _pieces.Select(piece => piece.Segment)]);
        _measure = (piece, place) => MayStandFor(_pieces[piece]) ? _pieces[piece].Segment.DistanceTo(place) : double.PositiveInfinity;
    }

    /// <summary>The largest distance of the move from what it stands for, where, and how large it may be; infinite when it stands for nothing.</summary>
    public (double Distance, Point2D At, double Allowed) Stray(in StrokeMove move)
    {
        _move = move;
        if (!_entities.Contains(move.EntityIndex)) return (double.PositiveInfinity, move.Segment.Start, 0.0); // a recovered arc has the entity of one of its lines
        var rounding = ToolpathTolerances.RoundingOf(move.Segment);
        var worst = (Distance: double.NegativeInfinity, At: move.Segment.Start, Allowed: 0.0);
        for (var i = 0; i < Places; i++)
        {
            var place = i == 0 ? move.Segment.Start : i == Places - 1 ? move.Segment.End : move.Segment.PointAt(i / (Places - 1.0));
            var (distance, piece) = From(place);
            if (piece < 0) return (double.PositiveInfinity, move.Segment.Start, 0.0);
            var allowed = _allowed[piece] + rounding;
            if (distance - allowed > worst.Distance - worst.Allowed) worst = (distance, place, allowed);
        }

        return worst;
    }

    /// <summary>Quick when questions follow a path: the last answer bounds the search.</summary>
    private (double Distance, int Piece) From(Point2D place)
    {
        var bound = _last < _pieces.Count ? _measure(_last, place) : double.PositiveInfinity;
        var piece = _index.NearestBy(_measure, place, bound, 0.0, out var distance);
        if (piece >= 0 && double.IsFinite(distance)) _last = piece;
        return double.IsFinite(distance) ? (distance, _last) : (distance, -1);
    }

    private bool MayStandFor(in StrokeMove row) =>
        row.EntityIndex == _move.EntityIndex || (_arcsRecovered && row.Segment.Kind == SegmentKind.Line && _move.Segment.Kind is SegmentKind.Arc or SegmentKind.Circle);
}
