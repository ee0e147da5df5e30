using Engraver.Core.Geometry;

namespace Engraver.Core.Verification;

/// <summary>Answers how far a place is from the nearest of many segments. Long segments stand in the tree as several pieces, so that a diagonal does not fill the whole drawing with its box.</summary>
internal sealed class SegmentIndex
{
    private const int PiecesPerSegment = 8;
    private const int PiecesAtLeast = 4096;
    private readonly IReadOnlyList<Segment> _segments;
    private readonly List<int> _owners = [];
    private readonly BoxTree _tree;
    private readonly BoxTree.Measure _measure;
    private int _last;

    /// <param name="segments">Ellipses and splines as their pieces (see <see cref="CurvePieces"/>).</param>
    public SegmentIndex(IReadOnlyList<Segment> segments)
    {
        _segments = segments;
        var pieceLength = segments.Sum(segment => segment.Length) / ((PiecesPerSegment * (double)segments.Count) + PiecesAtLeast);
        var boxes = new List<Bounds2D>();
        for (var i = 0; i < segments.Count; i++) AddPieces(i, pieceLength, boxes);
        _tree = BoxTree.Of([.. boxes]);
        _measure = (piece, place) => _segments[_owners[piece]].DistanceTo(place);
    }

    /// <summary>Distance to the nearest segment; infinite when there is none. Quick when questions follow a path: the last answer bounds the next search.</summary>
    public double DistanceFrom(Point2D place)
    {
        var bound = _segments.Count == 0 ? double.PositiveInfinity : _segments[_last].DistanceTo(place);
        var piece = _tree.Nearest(place, _measure, bound, out var distance);
        if (piece >= 0) _last = _owners[piece];
        return distance;
    }

    private void AddPieces(int index, double pieceLength, List<Bounds2D> boxes)
    {
        var segment = _segments[index];
        var pieces = pieceLength > 0.0 && !segment.IsFreeCurve ? Math.Max(1, (int)Math.Ceiling(segment.Length / pieceLength)) : 1;
        for (var piece = 0; piece < pieces; piece++)
        {
            boxes.Add(PieceBounds(segment, (double)piece / pieces, (piece + 1.0) / pieces));
            _owners.Add(index);
        }
    }

    private static Bounds2D PieceBounds(Segment segment, double from, double to)
    {
        if (segment.Kind == SegmentKind.Line) return Bounds2D.Of(segment.PointAt(from), segment.PointAt(to));
        if (segment.IsFreeCurve) return segment.Bounds;
        var arc = segment.Arc;
        return new ArcSegment(arc.Centre, arc.Radius, arc.Start + (arc.Sweep * from), arc.Sweep * (to - from)).Bounds;
    }
}
