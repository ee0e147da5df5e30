using Engraver.Core.Geometry;

namespace Engraver.Core.Verification.Corners;

/// <summary>A corner of the drawing and the region in which the tool may round it: between its two sides and the largest allowed arc.</summary>
/// <remarks>The distances from the drawing and from the region, whichever is smaller, change by at most the way between two places: the judges rely on
/// it.</remarks>
internal sealed class DrawnCorner
{
    /// <summary>A part of a path this far outside a straight border of the region, millimetres, is rounding.</summary>
    private const double Rounding = 1e-9;

    private readonly TangentCircle _circle;
    private readonly Point2D _centre;
    private readonly Point2D _contact;
    private readonly Point2D _contactSecond;
    private readonly Vector2D _toFirst;
    private readonly Vector2D _toSecond;
    private readonly double _slack;

    /// <param name="apex">The corner point.</param>
    /// <param name="first">The side from which a left turn about the corner point by less than half a turn leads to the other one.</param>
    /// <param name="second">The other side.</param>
    /// <param name="slack">Width by which the region is larger on every side: half the gap between the two drawn ends, and the distance of a curve from its
    /// arc.</param>
    public DrawnCorner(Point2D apex, in DrawnSide first, in DrawnSide second, in TangentCircle circle, double slack)
    {
        (Apex, First, Second, _circle, _slack) = (apex, first, second, circle, slack);
        (_centre, _contact, _contactSecond) = (apex + circle.Centre, apex + first.At(circle.First), apex + second.At(circle.Second));
        (_toFirst, _toSecond) = (-first.InwardAt(circle.First), -second.InwardAt(circle.Second));
    }

    /// <summary>The corner point, millimetres.</summary>
    public Point2D Apex { get; }

    public DrawnSide First { get; }

    public DrawnSide Second { get; }

    /// <summary>Length of a side inside the region.</summary>
    public double Extent => Math.Max(_circle.First, _circle.Second) + _slack;

    /// <summary>A box around the region.</summary>
    public OrientedBox Box()
    {
        var bend = Math.Max(Math.Abs(First.Curvature), Math.Abs(Second.Curvature)) * Extent * Extent;
        return OrientedBox.Around(_contact, _contactSecond, Apex).Grown(_slack + bend);
    }

    /// <summary>Distance from the region; 0 inside. Across a side it is infinite: the drawn side itself is nearer.</summary>
    public double DistanceTo(Point2D place)
    {
        var spoke = place - Apex;
        if (First.Inside(spoke) < 0.0 || Second.Inside(spoke) < 0.0)
            return _slack == 0.0 ? double.PositiveInfinity : Math.Max(0.0, FromSides(place) - _slack);
        var fromCentre = place - _centre;
        if (_toSecond.Cross(fromCentre) >= 0.0 && fromCentre.Cross(_toFirst) >= 0.0) return Math.Max(0.0, _circle.Radius - _slack - fromCentre.Length);
        return Math.Max(0.0, Math.Min(_contact.DistanceTo(place), _contactSecond.DistanceTo(place)) - _slack);
    }

    /// <summary>Upper bound of the distance of a line or an arc from the nearer of the region and the drawing; infinite when it is not simple.</summary>
    public double FarthestOf(in Segment part)
    {
        if (FarthestDistance.LinearRange(_centre, new Vector2D(-_toSecond.Y, _toSecond.X), part).Min < -Rounding) return double.PositiveInfinity;
        if (FarthestDistance.LinearRange(_centre, new Vector2D(_toFirst.Y, -_toFirst.X), part).Min < -Rounding) return double.PositiveInfinity;
        var beside = Math.Max(Beside(First, part), Beside(Second, part));
        return Math.Max(beside, Math.Max(0.0, _circle.Radius - _slack - FarthestDistance.RadialRange(_centre, part).Min));
    }

    /// <summary>True when a cut at a place counts as a cut of a side: within reach of the region.</summary>
    public bool IsNear(Point2D place, double reach)
    {
        var spoke = place - Apex;
        var width = reach + _slack;
        if (spoke.Length > Extent + reach) return false;
        return First.Inside(spoke) >= -width && Second.Inside(spoke) >= -width && place.DistanceTo(_centre) >= _circle.Radius - width;
    }

    /// <summary>True when a place in the corner is nearer to the first side than to the second.</summary>
    public bool IsAtFirst(Point2D place) => First.Inside(place - Apex) <= Second.Inside(place - Apex);

    private double FromSides(Point2D place) => Math.Min(Side(First, _contact).DistanceTo(place), Side(Second, _contactSecond).DistanceTo(place));

    /// <summary>Largest distance of a part from a side where it is outside, across that side.</summary>
    private double Beside(in DrawnSide side, in Segment part)
    {
        var outside = -side.LeastInside(Apex, part);
        return outside <= Rounding ? 0.0 : double.Hypot(outside, Math.Max(0.0, -FarthestDistance.LinearRange(Apex, side.Along, part).Min));
    }

    private Segment Side(in DrawnSide side, Point2D contact)
    {
        if (side.Curvature == 0.0 || contact == Apex) return Segment.FromLine(Apex, contact);
        var (centre, length) = (Apex + (side.Inward * (1.0 / side.Curvature)), contact == _contact ? _circle.First : _circle.Second);
        var turn = Math.Sign(side.Along.Cross(side.Inward)) * side.Curvature * length;
        return Segment.FromArc(new ArcSegment(centre, 1.0 / Math.Abs(side.Curvature), (Apex - centre).Direction, Angle.FromRadians(turn)));
    }
}
