using Engraver.Core.Geometry;

namespace Engraver.Core.Verification.Corners;

/// <summary>The parts of the sides of a corner that count as cut because the tool rounded it: those beside a cut in the region, and those up to the corner
/// point where the cut changes from one side to the other.</summary>
/// <param name="drawing">Ellipses and splines as their pieces.</param>
/// <param name="reach">Distance within which a cut covers, millimetres.</param>
/// <param name="covered">Receives the covered parts.</param>
/// <param name="counts">Selects the corners that count; all when null.</param>
internal sealed class CornerCover(Segment[] drawing, DrawnCorners corners, double reach, CoveredParts[] covered, Predicate<DrawnCorner>? counts = null)
{
    /// <summary>Places along a cut across a region.</summary>
    private const int Places = 32;

    /// <summary>The pieces nearest to the cut last: a line that crosses a corner can be nearer than its sides.</summary>
    private readonly int[] _pieces = [-1, -1, -1];
    private readonly int[] _cuts = new int[corners.Count];
    private int _cut;

    /// <summary>Number of corners that were compared with a cut.</summary>
    public long Steps { get; private set; }

    /// <summary>From now on <see cref="Add"/> reports a new cut.</summary>
    public void Begin() => _cut++;

    /// <summary>Adds a straight cut between two samples.</summary>
    /// <param name="nearest">The piece nearest to its end.</param>
    public void AddChord(Point2D from, Point2D to, int nearest)
    {
        if (corners.IsEmpty) return;
        Begin();
        Add(nearest, Segment.FromLine(from, to));
    }

    /// <summary>Adds a line or an arc.</summary>
    /// <param name="nearest">A piece near some part of it; repeated calls for one cut evaluate each corner once.</param>
    public void Add(int nearest, in Segment path)
    {
        if (corners.IsEmpty || nearest < 0) return;
        if (nearest != _pieces[0]) (_pieces[2], _pieces[1], _pieces[0]) = (_pieces[1], _pieces[0], nearest);
        foreach (var piece in _pieces)
        {
            foreach (var corner in corners.At(piece))
            {
                if (_cuts[corner] == _cut) continue;
                _cuts[corner] = _cut;
                if (counts?.Invoke(corners[corner]) != false) Cover(corners[corner], path);
            }
        }
    }

    private void Cover(DrawnCorner corner, in Segment path)
    {
        Steps++;
        if (PartIn(corner, path) is not var (from, to)) return;
        var steps = (int)Math.Clamp(Math.Ceiling(Places * path.Length * (to - from) / (2.0 * corner.Extent)), 1.0, Places);
        var before = default((bool IsFirst, SideFoot Foot)?);
        for (var i = 0; i <= steps; i++)
        {
            var place = path.PointAt(from + ((to - from) * i / steps));
            var now = FootOf(corner, place);
            if (before is { } last && now is { } next) Cover(corner, last, next);
            before = now;
        }
    }

    /// <summary>The part of a path near a corner, as fractions; null when it does not come near.</summary>
    private (double From, double To)? PartIn(DrawnCorner corner, in Segment path)
    {
        var (zone, length) = (corner.Extent + reach, path.Length);
        var (foot, distance) = PerpendicularFoot.Place(path, corner.Apex, double.NaN);
        if (distance > zone) return null;
        if (length == 0.0) return (0.0, 0.0);
        var half = Math.Sqrt((zone * zone) - (distance * distance));
        if (path.Kind != SegmentKind.Line) half = path.Arc.Radius > 4.0 * zone ? 1.1 * half : Math.PI * zone;
        return (Math.Max(0.0, foot - (half / length)), Math.Min(1.0, foot + (half / length)));
    }

    private (bool IsFirst, SideFoot Foot)? FootOf(DrawnCorner corner, Point2D place)
    {
        if (!corner.IsNear(place, reach)) return null;
        var isFirst = corner.IsAtFirst(place);
        var side = isFirst ? corner.First : corner.Second;
        var nearest = (Distance: double.PositiveInfinity, Foot: default(SideFoot));
        for (var i = 0; i < side.Pieces.Length; i++)
        {
            var (at, distance) = PerpendicularFoot.Place(drawing[side.Pieces[i]], place, double.NaN);
            if (distance < nearest.Distance) nearest = (distance, new SideFoot(i, side.IsFromStart ? at : 1.0 - at));
        }

        ref readonly var piece = ref drawing[side.Pieces[0]];
        var isOtherEnd = !piece.IsFreeCurve && nearest.Foot.Share * piece.Length > 2.0 * (corner.Extent + reach); // of an arc that almost closes
        return isOtherEnd ? null : (isFirst, nearest.Foot);
    }

    /// <summary>From one place to the next: on the same side the part between their feet, otherwise both parts to the corner point.</summary>
    private void Cover(DrawnCorner corner, (bool IsFirst, SideFoot Foot) last, (bool IsFirst, SideFoot Foot) next)
    {
        if (last.IsFirst == next.IsFirst)
        {
            Cover(last.IsFirst ? corner.First : corner.Second, last.Foot, next.Foot);
            return;
        }

        Cover(last.IsFirst ? corner.First : corner.Second, default, last.Foot);
        Cover(next.IsFirst ? corner.First : corner.Second, default, next.Foot);
    }

    private void Cover(in DrawnSide side, SideFoot one, SideFoot other)
    {
        var (near, far) = one.CompareTo(other) <= 0 ? (one, other) : (other, one);
        for (var i = near.Piece; i <= far.Piece; i++)
        {
            var (from, to) = (i == near.Piece ? near.Share : 0.0, i == far.Piece ? far.Share : 1.0);
            covered[side.Pieces[i]].Add(side.IsFromStart ? from : 1.0 - to, side.IsFromStart ? to : 1.0 - from);
        }
    }

    /// <summary>A place on a side.</summary>
    /// <param name="Piece">Index among the pieces of the side.</param>
    /// <param name="Share">Fraction of the piece from the corner point on.</param>
    private readonly record struct SideFoot(int Piece, double Share) : IComparable<SideFoot>
    {
        public int CompareTo(SideFoot other) => (Piece, Share).CompareTo((other.Piece, other.Share));
    }
}
