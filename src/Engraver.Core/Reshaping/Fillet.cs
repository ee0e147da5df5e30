using Engraver.Core.Geometry;

namespace Engraver.Core.Reshaping;

/// <summary>Two lines, arcs or circles joined by a tangent arc, or at a corner: the remaining part of each, cut or lengthened, and the connecting
/// segment.</summary>
/// <param name="First">Remaining part of the first (part 0); null for a circle, which stays complete.</param>
/// <param name="Second">Remaining part of the second; null for a circle.</param>
/// <param name="Between">The arc from the first to the second, or a chamfer's line; null at a corner.</param>
public sealed record Fillet(FilletSide? First, FilletSide? Second, Segment? Between)
{
    /// <summary>Two lines whose directions differ by less than this sine are parallel.</summary>
    private const double Parallel = 1e-10;

    /// <summary>Parallel lines nearer to each other than this fraction of their lengths and coordinates are on one line.</summary>
    private const double Collinear = 1e-9;

    /// <summary>The arc of a radius that touches both, the one nearest to the pick points.</summary>
    /// <param name="radius">Above 0; 0 joins them at a corner. For parallel lines half their distance is used instead.</param>
    /// <returns>Null when there is no such arc: the radius is too large, they do not meet, or one of them is an ellipse or spline.</returns>
    public static Fillet? Create(Segment first, Point2D pickedFirst, Segment second, Point2D pickedSecond, double radius)
    {
        if (first.IsFreeCurve || second.IsFreeCurve) return null;
        if (first.Kind == SegmentKind.Line && second.Kind == SegmentKind.Line && AreParallel(first, second)) return OfParallels(first, pickedFirst, second);
        if (radius == 0.0) return Corner(first, pickedFirst, second, pickedSecond);
        return Centres(first, second, radius)
            .Select(centre => At(first, second, centre, radius))
            .OfType<(Fillet Fillet, Point2D First, Point2D Second)>()
            .OrderBy(found => found.First.DistanceTo(pickedFirst) + found.Second.DistanceTo(pickedSecond))
            .Select(found => found.Fillet)
            .FirstOrDefault();
    }

    /// <summary>CHAMFER: A line between two lines, at a distance from their corner along each.</summary>
    /// <returns>Null when the lines are parallel or one is shorter than its distance.</returns>
    public static Fillet? Bevel(Segment first, Point2D pickedFirst, Segment second, Point2D pickedSecond, double alongFirst, double alongSecond)
    {
        if (first.Kind != SegmentKind.Line || second.Kind != SegmentKind.Line || AreParallel(first, second)) return null;
        if (Corner(first, pickedFirst, second, pickedSecond) is not { First: { } a, Second: { } b }) return null;
        if (Shortened(first, a, alongFirst) is not { } left || Shortened(second, b, alongSecond) is not { } right) return null;
        return new Fillet(left, right, left.Joint == right.Joint ? null : Segment.FromLine(left.Joint, right.Joint));
    }

    /// <summary>Possible centres of a touching circle: the crossings of both carriers, each moved by the radius to either side.</summary>
    private static IEnumerable<Point2D> Centres(Segment first, Segment second, double radius) =>
        from a in Moved(first, radius) from b in Moved(second, radius) from centre in SegmentCrossings.Carriers(a, b) select centre;

    private static IEnumerable<Segment> Moved(Segment segment, double radius)
    {
        if (segment.Kind == SegmentKind.Line)
        {
            var aside = segment.StartTangent is var way ? new Vector2D(-way.Y, way.X) * radius : default;
            return [Segment.FromLine(segment.Start + aside, segment.End + aside), Segment.FromLine(segment.Start - aside, segment.End - aside)];
        }

        var (centre, inner) = (segment.Arc.Centre, Math.Abs(segment.Arc.Radius - radius));
        return new[] { segment.Arc.Radius + radius, inner }.Where(size => size > 0.0).Select(size => Segment.FromArc(new ArcSegment(centre, size, Angle.Zero, Angle.FullTurn)));
    }

    private static (Fillet Fillet, Point2D First, Point2D Second)? At(Segment first, Segment second, Point2D centre, double radius)
    {
        var (from, to) = (Foot(first, centre, radius), Foot(second, centre, radius));
        var (start, end) = ((from - centre).Direction, (to - centre).Direction);
        var sweep = (from - centre).TurnTo(to - centre);
        if (sweep.Degrees == 0.0) return null;
        var between = Segment.FromArc(new ArcSegment(centre, radius, start, sweep), from, to);
        var (isFirst, isSecond) = (Kept(first, from, between.StartTangent, out var a), Kept(second, to, -between.EndTangent, out var b));
        return isFirst && isSecond ? (new Fillet(a, b, between), from, to) : null;
    }

    /// <summary>The place at which the circle about a centre touches the carrier.</summary>
    private static Point2D Foot(Segment segment, Point2D centre, double radius)
    {
        if (segment.Kind == SegmentKind.Line) return segment.Start + ((segment.End - segment.Start) * PathPlace.FractionOf(segment, centre));
        var way = centre - segment.Arc.Centre;
        var spoke = way * (segment.Arc.Radius / way.Length);
        var (near, far) = (segment.Arc.Centre + spoke, segment.Arc.Centre - spoke);
        return Math.Abs(near.DistanceTo(centre) - radius) <= Math.Abs(far.DistanceTo(centre) - radius) ? near : far;
    }

    /// <summary>The part that arrives at a place in a direction: from its start to the place, or from the place to its end.</summary>
    /// <returns>False when no part of it would remain, or an arc would have to be lengthened over more than half of its gap.</returns>
    private static bool Kept(Segment segment, Point2D place, Vector2D arriving, out FilletSide? kept)
    {
        kept = null;
        if (segment.Kind == SegmentKind.Circle) return true;
        var fraction = PathPlace.FractionOf(segment, place);
        var tangent = segment.Kind == SegmentKind.Line ? segment.StartTangent : TangentOf(segment.Arc, place);
        var isBefore = tangent.Dot(arriving) > 0.0;
        kept = FilletSide.Of(segment, fraction, place, isBefore);
        return isBefore ? fraction > 0.0 : fraction < 1.0;
    }

    private static Vector2D TangentOf(ArcSegment arc, Point2D place)
    {
        var spoke = (place - arc.Centre) * (arc.Sweep.Degrees >= 0.0 ? 1.0 / arc.Radius : -1.0 / arc.Radius);
        return new Vector2D(-spoke.Y, spoke.X);
    }

    /// <summary>Both end at the crossing nearest to the pick points, each with the picked side.</summary>
    private static Fillet? Corner(Segment first, Point2D pickedFirst, Segment second, Point2D pickedSecond) => SegmentCrossings.Carriers(first, second)
        .OrderBy(place => place.DistanceTo(pickedFirst) + place.DistanceTo(pickedSecond))
        .Select(place => (First: SideOf(first, pickedFirst, place), Second: SideOf(second, pickedSecond, place)))
        .Where(sides => sides.First.IsLeft && sides.Second.IsLeft)
        .Select(sides => new Fillet(sides.First.Kept, sides.Second.Kept, null))
        .FirstOrDefault();

    private static (FilletSide? Kept, bool IsLeft) SideOf(Segment segment, Point2D picked, Point2D corner)
    {
        if (segment.Kind == SegmentKind.Circle) return (null, true);
        var (pick, fraction) = (PathPlace.Nearest(0, segment, picked).Fraction, PathPlace.FractionOf(segment, corner));
        return (FilletSide.Of(segment, fraction, corner, pick < fraction), pick < fraction ? fraction > 0.0 : fraction < 1.0);
    }

    /// <summary>A half turn at the end of the first that is nearer to its pick point; the second ends opposite to it.</summary>
    private static Fillet? OfParallels(Segment first, Point2D picked, Segment second)
    {
        var atStart = first.Start.DistanceTo(picked) < first.End.DistanceTo(picked);
        var (from, outward) = atStart ? (first.Start, -first.StartTangent) : (first.End, first.StartTangent);
        var to = second.Start + ((second.End - second.Start) * PathPlace.FractionOf(second, from));
        var across = to - from;
        if (across.Length <= Collinear * (first.Length + second.Length + Math.Abs(from.X) + Math.Abs(from.Y))) return null;
        var centre = from + (across * 0.5);
        var sweep = Angle.FromDegrees(outward.Cross(across) > 0.0 ? 180.0 : -180.0);
        var between = Segment.FromArc(new ArcSegment(centre, across.Length / 2.0, (-across).Direction, sweep), from, to);
        return Kept(second, to, outward, out var kept) ? new Fillet(new FilletSide(PathRange.Whole(0, first), !atStart), kept, between) : null;
    }

    private static FilletSide? Shortened(Segment line, FilletSide side, double by)
    {
        if (line.Length == 0.0) return null;
        var (share, kept) = (by / line.Length, side.Remaining);
        var at = side.EndsAtJoint ? kept.To - share : kept.From + share;
        if (side.EndsAtJoint ? at <= 0.0 : at >= 1.0) return null;
        return FilletSide.Of(line, at, by == 0.0 ? side.Joint : line.PointAt(at), side.EndsAtJoint);
    }

    private static bool AreParallel(Segment a, Segment b) => Math.Abs(a.StartTangent.Cross(b.StartTangent)) < Parallel;
}
