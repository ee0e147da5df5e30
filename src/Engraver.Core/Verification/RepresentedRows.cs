using Engraver.Core.Geometry;
using Engraver.Core.Sequencing;

namespace Engraver.Core.Verification;

/// <summary>Determines the distance of a move from the rows that it can represent: those of its entity and, when arcs were recovered, any line for an
/// arc.</summary>
/// <remarks>Each entity is evaluated separately, so that thousands of entities that cross it take no additional time.</remarks>
internal sealed class RepresentedRows
{
    /// <summary>Number of places of a move that are checked, including both ends.</summary>
    private const int Places = 9;

    private readonly Dictionary<int, DrawnRows> _byEntity;
    private readonly DrawnRows? _lines;

    /// <param name="rows">Rows without a paired move.</param>
    public RepresentedRows(IReadOnlyList<StrokeMove> rows, ToolpathTolerances tolerances)
    {
        _byEntity = rows.GroupBy(row => row.EntityIndex).ToDictionary(group => group.Key, group => new DrawnRows([.. group], tolerances));
        if (tolerances.ArcsRecovered) _lines = new DrawnRows([.. rows.Where(row => row.Segment.Kind == SegmentKind.Line)], tolerances);
    }

    /// <summary>Number of distances computed and boxes checked so far.</summary>
    public long Steps => _byEntity.Values.Sum(rows => rows.Steps) + (_lines?.Steps ?? 0);

    /// <summary>The largest distance of the move from the rows that it represents, its place, and the allowed distance; infinite when it represents no
    /// row.</summary>
    public (double Distance, Point2D At, double Allowed) MaxDistance(in StrokeMove move)
    {
        var segment = move.Segment;
        if (!_byEntity.TryGetValue(move.EntityIndex, out var own)) return (double.PositiveInfinity, segment.Start, 0.0); // a recovered arc has the entity of one of its lines
        var lines = segment.Kind is SegmentKind.Arc or SegmentKind.Circle ? _lines : null;
        var rounding = ToolpathTolerances.RoundingOf(segment);
        var worst = (Distance: double.NegativeInfinity, At: segment.Start, Allowed: 0.0);
        for (var i = 0; i < Places; i++)
        {
            var place = i == 0 ? segment.Start : i == Places - 1 ? segment.End : segment.PointAt(i / (Places - 1.0));
            var nearest = own.NearestTo(place);
            if (lines?.NearestTo(place) is { } line && line.Distance < nearest.Distance) nearest = line;
            if (!double.IsFinite(nearest.Distance)) return (double.PositiveInfinity, segment.Start, 0.0);
            var allowed = nearest.Allowed + rounding;
            if (nearest.Distance - allowed > worst.Distance - worst.Allowed) worst = (nearest.Distance, place, allowed);
        }

        return worst;
    }

    /// <summary>Rows as pieces. The index is built at the first query: duplicates have no move and are never queried.</summary>
    private sealed class DrawnRows(IReadOnlyList<StrokeMove> rows, ToolpathTolerances tolerances)
    {
        /// <summary>A small number: pieces of one entity are rarely crowded, and there can be as many indexes as entities.</summary>
        private const double BoxesPerPiece = 2.0;

        private readonly List<double> _allowed = [];
        private SegmentIndex? _index;

        public long Steps => _index?.Steps ?? 0;

        /// <summary>Distance of the nearest row, and the allowed distance; infinite when there is no row.</summary>
        public (double Distance, double Allowed) NearestTo(Point2D place)
        {
            var piece = (_index ??= Index()).NearestTo(place, out var distance);
            return piece < 0 ? (double.PositiveInfinity, 0.0) : (distance, _allowed[piece]);
        }

        private SegmentIndex Index()
        {
            var pieces = new List<Segment>();
            foreach (var row in rows)
            {
                pieces.AddRange(CurvePieces.Split([row.Segment]));
                while (_allowed.Count < pieces.Count) _allowed.Add(tolerances.For(row.Segment));
            }

            return new SegmentIndex([.. pieces], SegmentBoxes.From(pieces, BoxesPerPiece * pieces.Count));
        }
    }
}
