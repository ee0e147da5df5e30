using Engraver.Core.Geometry;

namespace Engraver.Core.Verification;

/// <summary>Determines the distance of a place from the nearest of many segments, and whether a cut comes near any of them. Only a few are checked even when
/// they are crowded, because their boxes are oriented along them.</summary>
internal sealed class SegmentIndex
{
    private readonly Segment[] _segments;
    private readonly int[] _owners;
    private readonly (double From, double To)[] _parts;
    private readonly OrientedBoxTree _tree;
    private readonly BoxTree.Measure _distance;
    private readonly BoxTree.Measure _measureOnce;
    private readonly int[] _stamps;
    private int _stamp;
    private long _measured;
    private BoxTree.Measure _measure;
    private int _last;
    private double _foot = double.NaN;

    /// <summary>A condition on a segment between two of its fractions.</summary>
    public delegate bool Question(int segment, double from, double to);

    /// <param name="segments">Ellipses and splines as their pieces (see <see cref="CurvePieces"/>).</param>
    public SegmentIndex(Segment[] segments)
        : this(segments, SegmentBoxes.From(segments))
    {
    }

    /// <param name="segments">Segments as above.</param>
    /// <param name="pieces">Their boxes; fewer boxes shorten the build time.</param>
    public SegmentIndex(Segment[] segments, SegmentBoxes pieces)
    {
        _segments = segments;
        _stamps = new int[segments.Length];
        (_owners, _parts) = (pieces.Owners, pieces.Parts);
        _tree = OrientedBoxTree.Build(pieces.Boxes);
        _measure = _distance = Distance;
        _measureOnce = MeasureOnce;
    }

    /// <summary>Number of segment distances computed and boxes checked so far.</summary>
    public long Steps => _tree.Steps + _measured;

    /// <summary>Number and distance of the nearest segment; -1 and infinite when there is none. Fast for queries along a path: the last result bounds the next
    /// search.</summary>
    public int NearestTo(Point2D place, out double distance)
    {
        distance = double.PositiveInfinity;
        if (_segments.Length == 0) return -1;
        return NearestTo(place, Distance(_last, place), 0.0, out distance);
    }

    /// <summary>The nearest segment by a given measure; -1 when none is as near as <paramref name="within"/>.</summary>
    /// <param name="measure">Measure by number of the segment; never less than its distance.</param>
    /// <param name="enough">The first segment within this distance is accepted.</param>
    public int NearestBy(BoxTree.Measure measure, Point2D place, double within, double enough, out double distance)
    {
        _stamp++;
        _measure = measure;
        var piece = _tree.Nearest(place, _measureOnce, within, enough, out distance);
        return piece >= 0 ? _owners[piece] : -1;
    }

    /// <summary>As <see cref="NearestTo(Point2D, out double)"/>, but any segment within <paramref name="enough"/> is accepted, the last result first. This
    /// avoids a query of all segments for a path along one of many crowded segments.</summary>
    public int NearEnoughTo(Point2D place, double enough, out double distance)
    {
        distance = double.PositiveInfinity;
        if (_segments.Length == 0) return -1;
        if (_segments[_last].IsFreeCurve && IsNearLast(place, enough, out distance)) return _last;
        distance = Distance(_last, place);
        return distance <= enough ? _last : NearestTo(place, distance, enough, out distance);
    }

    /// <summary>The foot on a curve moves little from one place to the next, and a point of the curve that is near enough is sufficient: the exact distance,
    /// which takes ten times as long, is not larger.</summary>
    private bool IsNearLast(Point2D place, double enough, out double distance)
    {
        _measured++;
        (_foot, distance) = PerpendicularFoot.Place(_segments[_last], place, _foot);
        return distance <= enough;
    }

    /// <summary>False when no segment comes within reach of a line, an arc or a piece of a curve; true when a segment is or can be within reach.</summary>
    public bool ComesNear(Segment path, double reach) =>
        ComesNear(path, reach, (segment, from, to) => SegmentSeparation.CanBeNear(path, SegmentPart.Of(_segments[segment], from, to), reach));

    /// <summary>As above, with a condition on each part of a segment whose box is within reach.</summary>
    public bool ComesNear(in Segment path, double reach, Question isNear) => _tree.ComesNear(path, reach, piece =>
    {
        _measured++;
        return isNear(_owners[piece], _parts[piece].From, _parts[piece].To);
    });

    private int NearestTo(Point2D place, double within, double enough, out double distance)
    {
        var nearest = NearestBy(_distance, place, within, enough, out distance);
        return nearest >= 0 ? _last = nearest : _last; // none found: the last one is the nearest
    }

    /// <summary>Each piece of a segment measures the whole segment, so that one is sufficient.</summary>
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
