using Engraver.Core.Geometry;

namespace Engraver.Core.Offsets.Pieces;

/// <summary>Crossings of two pieces. Pieces on one line or circle give the ends of their common part; pieces that only touch, in a tangent point, do not
/// cross.</summary>
internal static class PieceCrossings
{
    /// <summary>Maximum number of points that two pieces can give.</summary>
    public const int MaxCount = 6;

    /// <param name="first">One piece.</param>
    /// <param name="second">The other.</param>
    /// <param name="tolerance">Distance that counts as zero: beyond an end, between two lines, between tangent circles.</param>
    /// <param name="found">Room for <see cref="MaxCount"/>.</param>
    /// <returns>Number of points found.</returns>
    public static int Between(in PathPiece first, in PathPiece second, double tolerance, Span<Crossing> found)
    {
        var into = new CommonPoints(first, second, tolerance, found);
        AddCrossings(ref into);
        return into.Count;
    }

    /// <summary>The same, and the ends of either piece that touch the other: where an end is in a tangent point, two pieces meet without crossing.</summary>
    /// <param name="first">One piece.</param>
    /// <param name="second">The other.</param>
    /// <param name="tolerance">Distance that counts as zero.</param>
    /// <param name="found">Room for <see cref="MaxCount"/>.</param>
    /// <returns>Number of points found; an end is preferred to a crossing near it.</returns>
    public static int BetweenWithEnds(in PathPiece first, in PathPiece second, double tolerance, Span<Crossing> found)
    {
        var into = new CommonPoints(first, second, tolerance, found);
        if (second.DistanceTo(first.Start) <= tolerance) into.Offer(first.Start);
        if (second.DistanceTo(first.End) <= tolerance) into.Offer(first.End);
        if (first.DistanceTo(second.Start) <= tolerance) into.Offer(second.Start);
        if (first.DistanceTo(second.End) <= tolerance) into.Offer(second.End);
        AddCrossings(ref into);
        return into.Count;
    }

    private static void AddCrossings(ref CommonPoints into)
    {
        var (first, second) = (into.First, into.Second);
        if (!first.IsArc && !second.IsArc) OfLines(ref into);
        else if (!first.IsArc) OfLineAndCircle(ref into, first, second);
        else if (!second.IsArc) OfLineAndCircle(ref into, second, first);
        else OfCircles(ref into);
    }

    /// <summary>Distance by which the computed crossing of two neighbours can miss the point that joins them, where they are almost tangent.</summary>
    /// <param name="leaving">Direction at the end of the first.</param>
    /// <param name="arriving">Direction at the start of the second.</param>
    /// <param name="radius">The larger radius of the two; 0 for lines.</param>
    /// <returns>Null for neighbours that are not almost tangent: their crossing is computed exactly.</returns>
    public static double? JointError(Vector2D leaving, Vector2D arriving, double radius)
    {
        var sine = Math.Abs(leaving.Cross(arriving));
        return sine < 1e-3 ? 4.0 * Math.Max(sine, 1e-7) * radius : null;
    }

    private static void OfLines(ref CommonPoints into)
    {
        var (first, second) = (into.First, into.Second);
        var (along, other) = (first.End - first.Start, second.End - second.Start);
        var cross = along.Cross(other);
        if (Math.Abs(cross) <= into.Tolerance * Math.Max(first.Length, second.Length))
        {
            if (IsNearLine(first, second.Start, into.Tolerance) || IsNearLine(first, second.End, into.Tolerance)) OfOneLine(ref into);
            return;
        }

        var fraction = (second.Start - first.Start).Cross(other) / cross;
        into.Offer(first.Start + (along * fraction));
    }

    private static bool IsNearLine(in PathPiece line, Point2D place, double tolerance) =>
        Math.Abs((line.End - line.Start).Cross(place - line.Start)) <= 2.0 * tolerance * line.Length;

    private static void OfOneLine(ref CommonPoints into)
    {
        into.Offer(into.First.Start);
        into.Offer(into.First.End);
        into.Offer(into.Second.Start);
        into.Offer(into.Second.End);
    }

    private static void OfLineAndCircle(ref CommonPoints into, in PathPiece line, in PathPiece arc)
    {
        var direction = (line.End - line.Start) * (1.0 / line.Length);
        var toCentre = arc.Centre - line.Start;
        var height = direction.Cross(toCentre);
        var room = arc.Radius - Math.Abs(height);
        if (room <= into.Tolerance) return;
        var half = Math.Sqrt(room * (arc.Radius + Math.Abs(height)));
        var foot = toCentre.Dot(direction);
        into.Offer(line.Start + (direction * (foot - half)));
        into.Offer(line.Start + (direction * (foot + half)));
    }

    /// <summary>Computed from the centre of the smaller circle: from the centre of a circle of 30 m, which is nearly a line, half the chord would be wrong by
    /// 1e-8.</summary>
    private static void OfCircles(ref CommonPoints into)
    {
        var (first, second, tolerance) = (into.First, into.Second, into.Tolerance);
        var between = second.Centre - first.Centre;
        var distance = PathPiece.Norm(between);
        if (distance <= tolerance && Math.Abs(first.Radius - second.Radius) <= tolerance)
        {
            OfOneLine(ref into);
            return;
        }

        if (distance >= first.Radius + second.Radius - tolerance || distance <= Math.Abs(first.Radius - second.Radius) + tolerance) return;
        var (small, large) = first.Radius <= second.Radius ? (first, second) : (second, first);
        var unit = (large.Centre - small.Centre) * (1.0 / distance);
        var along = (distance / 2.0) + ((small.Radius - large.Radius) * (small.Radius + large.Radius) / (2.0 * distance));
        var half = Math.Sqrt(Math.Max(0.0, (small.Radius - along) * (small.Radius + along)));
        var (foot, across) = (small.Centre + (unit * along), new Vector2D(-unit.Y, unit.X) * half);
        into.Offer(foot + across);
        into.Offer(foot - across);
    }

    /// <summary>Keeps points that are on both pieces, each once.</summary>
    private ref struct CommonPoints(in PathPiece first, in PathPiece second, double tolerance, Span<Crossing> found)
    {
        private readonly Span<Crossing> _found = found;

        public PathPiece First { get; } = first;

        public PathPiece Second { get; } = second;

        public double Tolerance { get; } = tolerance;

        public int Count { get; private set; }

        public void Offer(Point2D place)
        {
            if (Fraction(First, place) is not { } onFirst || Fraction(Second, place) is not { } onSecond) return;
            for (var i = 0; i < Count; i++)
            {
                if (_found[i].Place.IsNear(place, 2.0 * Tolerance)) return;
            }

            _found[Count++] = new Crossing(place, onFirst, onSecond);
        }

        private readonly double? Fraction(in PathPiece piece, Point2D place)
        {
            var fraction = piece.FractionOf(place);
            var slack = Tolerance / piece.Length;
            if (fraction < -slack || fraction > 1.0 + slack) return null;
            return fraction <= slack ? 0.0 : fraction >= 1.0 - slack ? 1.0 : fraction;
        }
    }
}
