using Engraver.Core.Geometry;

namespace Engraver.Core.Verification;

/// <summary>Answers how far a place is from the nearest of many segments, and which segments a cut runs near. However crowded they are, few are looked at: their boxes lie along them.</summary>
internal sealed class SegmentIndex
{
    private readonly IReadOnlyList<Segment> _segments;
    private readonly int[] _owners;
    private readonly OrientedBoxTree _tree;
    private readonly BoxTree.Measure _measure;
    private readonly List<int> _found = [];
    private readonly int[] _stamps;
    private int _stamp;
    private int _last;

    /// <param name="segments">Ellipses and splines as their pieces (see <see cref="CurvePieces"/>).</param>
    public SegmentIndex(IReadOnlyList<Segment> segments)
    {
        _segments = segments;
        _stamps = new int[segments.Count];
        var pieces = SegmentBoxes.Of(segments);
        _owners = pieces.Owners;
        _tree = OrientedBoxTree.Of(pieces.Boxes);
        _measure = (piece, place) => MeasureOnce(_owners[piece], place);
    }

    /// <summary>Distances of segments that were computed and boxes that were looked at so far.</summary>
    public long Steps => _tree.Steps + _measured;

    private long _measured;

    /// <summary>Number and distance of the nearest segment; -1 and infinite when there is none. Quick when questions follow a path: the last answer bounds the next search.</summary>
    public int NearestTo(Point2D place, out double distance)
    {
        distance = double.PositiveInfinity;
        if (_segments.Count == 0) return -1;
        _stamp++;
        var piece = _tree.Nearest(place, _measure, Measure(_last, place), out distance);
        return piece >= 0 ? _last = _owners[piece] : _last; // none found: none is nearer than the last
    }

    /// <summary>As <see cref="NearestTo"/>, but the last answer again while it is no farther than <paramref name="enough"/>: the nearest is no farther either. Keeps a path along one of many crowded segments from asking all of them.</summary>
    public int NearEnoughTo(Point2D place, double enough, out double distance)
    {
        distance = _segments.Count == 0 ? double.PositiveInfinity : Measure(_last, place);
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
    private double MeasureOnce(int segment, Point2D place)
    {
        if (_stamps[segment] == _stamp) return double.PositiveInfinity;
        _stamps[segment] = _stamp;
        return Measure(segment, place);
    }

    private double Measure(int segment, Point2D place)
    {
        _measured++;
        return _segments[segment].DistanceTo(place);
    }
}
