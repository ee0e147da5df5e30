using Engraver.Core.Geometry;

namespace Engraver.Core.Verification.Corners;

/// <summary>The corners of a drawing that may be rounded, and the distance of a place from their regions; none when the corner tolerance is 0.</summary>
internal sealed class DrawnCorners
{
    /// <summary>Number of corners that are kept: the tool comes to one after the other.</summary>
    private const int Kept = 256;

    private readonly CornerFinder _finder;
    private readonly (int Corner, DrawnCorner? Drawn)[] _kept;
    private readonly OrientedBoxTree _tree;
    private readonly BoxTree.Measure _measure;
    private readonly double _count;
    private readonly int[] _first;
    private readonly int[] _atPieces;
    private long _measured;
    private int _last;

    private DrawnCorners(int pieces, CornerFinder finder, double count)
    {
        var (boxes, places) = (finder.Boxes, finder.Places);
        (_finder, _count, Count) = (finder, count, boxes.Length);
        _kept = new (int Corner, DrawnCorner? Drawn)[Math.Min(Kept, boxes.Length)];
        _tree = OrientedBoxTree.Build(boxes);
        _measure = Measure;
        (_first, _atPieces) = (new int[boxes.Length == 0 ? 0 : pieces + 1], new int[places.Count]);
        foreach (var (piece, _) in places) _first[piece]++;
        for (var i = 1; i < _first.Length; i++) _first[i] += _first[i - 1];
        foreach (var (piece, corner) in places) _atPieces[--_first[piece]] = corner;
    }

    /// <summary>True when no place may be off the drawing.</summary>
    public bool IsEmpty => Count == 0;

    /// <summary>True when there is a corner tolerance, also for a drawing without corners.</summary>
    public bool IsUsed { get; private init; }

    /// <summary>Number of corners and boxes checked so far.</summary>
    public long Steps => _tree.Steps + _measured;

    public int Count { get; }

    public DrawnCorner this[int corner]
    {
        get
        {
            ref var kept = ref _kept[corner % Kept];
            if (kept.Drawn is null || kept.Corner != corner) kept = (corner, _finder.Create(corner));
            return kept.Drawn!;
        }
    }

    /// <param name="pieces">The drawing: ellipses and splines as their pieces.</param>
    /// <param name="heightOf">The height of a piece at its start (true) or end: only ends at one height are joined; null where heights do not count.</param>
    public static DrawnCorners Of(Segment[] pieces, TraceTolerances tolerances, Func<int, bool, double>? heightOf = null)
    {
        return new DrawnCorners(pieces.Length, CornerFinder.Find(pieces, tolerances, heightOf), tolerances.Count) { IsUsed = tolerances.CornerTolerance > 0.0 };
    }

    /// <summary>The corners at the ends of a piece.</summary>
    public ReadOnlySpan<int> At(int piece) => IsEmpty || piece < 0 ? [] : _atPieces.AsSpan(_first[piece], _first[piece + 1] - _first[piece]);

    /// <summary>The corner whose region is nearest to a place; -1 when none is nearer than <paramref name="within"/>, or when that is at most a count: such a
    /// place is on the drawing.</summary>
    /// <param name="within">Distance of the place from the drawing.</param>
    /// <param name="enough">The first corner within this distance is accepted; a count is always enough.</param>
    /// <param name="distance">Distance from its region, at least a count; or <paramref name="within"/>.</param>
    public int NearestTo(Point2D place, double within, double enough, out double distance) => NearestBy(_measure, place, within, enough, out distance);

    /// <summary>As <see cref="NearestTo"/>, by a given measure of a corner, which is never less than the distance from its region.</summary>
    public int NearestBy(BoxTree.Measure measure, Point2D place, double within, double enough, out double distance)
    {
        distance = within;
        if (IsEmpty || within <= _count) return -1;
        enough = Math.Max(enough, _count);
        distance = Math.Min(within, measure(_last, place)); // of many corners in one place, the tool rounds one after the other
        if (distance <= enough)
        {
            distance = Math.Max(distance, _count);
            return _last;
        }

        if (_tree.Nearest(place, measure, distance, enough, out distance) is >= 0 and var corner) _last = corner;
        distance = Math.Max(distance, _count);
        return distance < within ? _last : -1;
    }

    /// <summary>False when no region comes within reach of a line or an arc.</summary>
    public bool ComesNear(in Segment path, double reach) => !IsEmpty && _tree.ComesNear(path, reach);

    private double Measure(int corner, Point2D place)
    {
        _measured++;
        return this[corner].DistanceTo(place);
    }
}
