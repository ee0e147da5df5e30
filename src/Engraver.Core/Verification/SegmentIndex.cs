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
    private readonly List<int> _found = [];
    private readonly int[] _stamps;
    private int _stamp = 1;
    private int _last;

    /// <param name="segments">Ellipses and splines as their pieces (see <see cref="CurvePieces"/>).</param>
    public SegmentIndex(IReadOnlyList<Segment> segments)
    {
        _segments = segments;
        _stamps = new int[segments.Count];
        var pieceLength = segments.Sum(segment => segment.Length) / ((PiecesPerSegment * (double)segments.Count) + PiecesAtLeast);
        var boxes = new List<Bounds2D>();
        for (var i = 0; i < segments.Count; i++) AddPieces(i, pieceLength, boxes);
        _tree = BoxTree.Of([.. boxes]);
        _measure = (piece, place) => _segments[_owners[piece]].DistanceTo(place);
    }

    /// <summary>Distance to the nearest segment; infinite when there is none. Quick when questions follow a path: the last answer bounds the next search.</summary>
    public double DistanceFrom(Point2D place)
    {
        NearestTo(place, out var distance);
        return distance;
    }

    /// <summary>Number and distance of the nearest segment; -1 and infinite when there is none.</summary>
    public int NearestTo(Point2D place, out double distance)
    {
        var bound = _segments.Count == 0 ? double.PositiveInfinity : _segments[_last].DistanceTo(place);
        var piece = _tree.Nearest(place, _measure, bound, out distance);
        if (piece >= 0) _last = _owners[piece];
        return _segments.Count == 0 ? -1 : _last; // none found: none is nearer than the last
    }

    /// <summary>As <see cref="NearestTo"/>, but the last answer again while it is no farther than <paramref name="enough"/>: the nearest is no farther either. Keeps a path along one of many crowded segments from asking all of them.</summary>
    public int NearEnoughTo(Point2D place, double enough, out double distance)
    {
        distance = _segments.Count == 0 ? double.PositiveInfinity : _segments[_last].DistanceTo(place);
        return distance <= enough ? _last : NearestTo(place, out distance);
    }

    /// <summary>Adds the segments of which some part's box overlaps a box; each once until <see cref="Forget"/>.</summary>
    public void Overlapping(Bounds2D box, List<int> found)
    {
        _found.Clear();
        _tree.Overlapping(box, _found);
        AddOwners(found);
    }

    /// <summary>Adds the segments of which some part's box comes within reach of a line; each once until <see cref="Forget"/>.</summary>
    public void Along(LineSegment line, double reach, List<int> found)
    {
        _found.Clear();
        _tree.Along(line, reach, _found);
        AddOwners(found);
    }

    /// <summary>More than so many parts of segments have boxes that overlap a box.</summary>
    public bool IsCrowded(Bounds2D box, int many)
    {
        _found.Clear();
        _tree.Overlapping(box, _found);
        return _found.Count > many;
    }

    /// <summary>What was found is found again.</summary>
    public void Forget() => _stamp++;

    private void AddOwners(List<int> found)
    {
        foreach (var piece in _found)
        {
            var owner = _owners[piece];
            if (_stamps[owner] == _stamp) continue;
            _stamps[owner] = _stamp;
            found.Add(owner);
        }
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
