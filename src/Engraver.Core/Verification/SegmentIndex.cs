using Engraver.Core.Geometry;

namespace Engraver.Core.Verification;

/// <summary>Answers how far a place is from the nearest of many segments, and which segments a cut runs near. However crowded they are, few are looked at: their boxes lie along them.</summary>
internal sealed class SegmentIndex
{
    private readonly Segment[] _segments;
    private readonly int[] _owners;
    private readonly OrientedBoxTree _tree;
    private readonly BoxTree.Measure _distance;
    private readonly BoxTree.Measure _measureOnce;
    private readonly List<int> _found = [];
    private readonly int[] _stamps;
    private int _stamp;
    private long _measured;
    private BoxTree.Measure _measure;
    private int _last;

    /// <param name="segments">Ellipses and splines as their pieces (see <see cref="CurvePieces"/>).</param>
    /// <param name="crossed">Sine of the angle from which on a line across a segment is nothing to it; without it none is.</param>
    public SegmentIndex(Segment[] segments, Func<Segment, double>? crossed = null)
    {
        _segments = segments;
        _stamps = new int[segments.Length];
        var pieces = SegmentBoxes.From(segments);
        _owners = pieces.Owners;
        _tree = OrientedBoxTree.Build(pieces.Boxes, [.. pieces.Turns.Select((turn, piece) => new Slant(turn, crossed?.Invoke(segments[pieces.Owners[piece]]) ?? 1.0))]);
        _measure = _distance = Distance;
        _measureOnce = MeasureOnce;
    }

    /// <summary>Distances of segments that were computed and boxes that were looked at so far.</summary>
    public long Steps => _tree.Steps + _measured;

    /// <summary>Number and distance of the nearest segment; -1 and infinite when there is none. Quick when questions follow a path: the last answer bounds the next search.</summary>
    public int NearestTo(Point2D place, out double distance)
    {
        distance = double.PositiveInfinity;
        if (_segments.Length == 0) return -1;
        var nearest = NearestBy(_distance, place, Distance(_last, place), out distance);
        return nearest >= 0 ? _last = nearest : _last; // none found: none is nearer than the last
    }

    /// <summary>The nearest segment by a measure of one's own; -1 when none is as near as <paramref name="within"/>.</summary>
    /// <param name="measure">By number of the segment; nowhere less than its distance.</param>
    public int NearestBy(BoxTree.Measure measure, Point2D place, double within, out double distance)
    {
        _stamp++;
        _measure = measure;
        var piece = _tree.Nearest(place, _measureOnce, within, out distance);
        return piece >= 0 ? _owners[piece] : -1;
    }

    /// <summary>As <see cref="NearestTo"/>, but the last answer again while it is no farther than <paramref name="enough"/>: the nearest is no farther either. Keeps a path along one of many crowded segments from asking all of them.</summary>
    public int NearEnoughTo(Point2D place, double enough, out double distance)
    {
        distance = _segments.Length == 0 ? double.PositiveInfinity : Distance(_last, place);
        return distance <= enough ? _last : NearestTo(place, out distance);
    }

    /// <summary>The segments of which some part's box comes within a radius of a place, each once.</summary>
    public void Around(Point2D place, double radius, List<int> found)
    {
        _found.Clear();
        _tree.Around(place, radius, _found);
        TellOwners(found);
    }

    /// <summary>The segments of which some part's box comes within reach of a line or an arc (or nearly), each once.</summary>
    public void Along(in Segment path, double reach, List<int> found)
    {
        _found.Clear();
        _tree.Along(path, reach, _found);
        TellOwners(found);
    }

    /// <summary>As <see cref="Along"/> a line, without the segments that it only crosses.</summary>
    public void AlongNotAcross(LineSegment line, double reach, List<int> found)
    {
        _found.Clear();
        _tree.AlongNotAcross(line, reach, _found);
        TellOwners(found);
    }

    /// <summary>False when no segment comes within reach of a line or an arc; true when one does, or may.</summary>
    public bool ComesNear(in Segment path, double reach)
    {
        _found.Clear();
        _tree.Along(path, reach, _found);
        return _found.Count > 0;
    }

    private void TellOwners(List<int> found)
    {
        _stamp++;
        found.Clear();
        foreach (var piece in _found)
        {
            var owner = _owners[piece];
            if (_stamps[owner] == _stamp) continue;
            _stamps[owner] = _stamp;
            found.Add(owner);
        }
    }

    /// <summary>Pieces of a segment measure the whole of it, so that one is enough.</summary>
    private double MeasureOnce(int piece, Point2D place)
    {
        var segment = _owners[piece];
        if (_stamps[segment] == _stamp) return double.PositiveInfinity;
        _stamps[segment] = _stamp;
        return _measure(segment, place);
    }

    private double Distance(int segment, Point2D place)
    {
        _measured++;
        return _segments[segment].DistanceTo(place);
    }
}
