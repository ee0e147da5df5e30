namespace Engraver.Benchmarks.Motion;

/// <summary>Rounds the corners of a stroke by the largest single arcs within the tolerance.</summary>
/// <remarks>The length that an arc replaces before the corner is searched; the arc that is tangent there and to the element after the corner follows from it.
/// Arcs that share a side divide it in proportion to the lengths that they would replace alone; what one of them leaves is used by the other.</remarks>
internal static class CornerRounding
{
    private const int Halvings = 50;
    private const int Rounds = 3;

    /// <summary>What is left of a side between two arcs is left out where it is shorter, mm.</summary>
    private const double ShortestRest = 1e-6;

    /// <summary>Smaller turns are rounding of the numbers, radians.</summary>
    private const double SmallestTurn = 1e-5;

    /// <summary>A corner of short chords is rounded also where its arc is as slow as the corner.</summary>
    private const double SameSpeed = 0.95;

    /// <param name="Radius">0: the corner is not rounded.</param>
    /// <param name="Before">Length replaced before the corner.</param>
    /// <param name="After">Length replaced after it.</param>
    private readonly record struct Fillet(double Radius, double Before, double After, PathElement Arc);

    public static IReadOnlyList<PathPart> Rounded(IReadOnlyList<PathElement> stroke, MotionBounds bounds)
    {
        var fillets = new Fillet[stroke.Count + 1]; // by the element after the corner
        for (var i = 1; i < stroke.Count; i++) fillets[i] = Largest(stroke[i - 1], stroke[i], stroke[i - 1].Length, stroke[i].Length, bounds);
        var wanted = (Fillet[])fillets.Clone();
        for (var i = 1; i < stroke.Count; i++) fillets[i] = Largest(stroke[i - 1], stroke[i], Share(i - 1, atEnd: true), Share(i, atEnd: false), bounds);
        for (var round = 0; round < Rounds; round++)
        {
            for (var i = 1; i < stroke.Count; i++)
            {
                fillets[i] = Largest(stroke[i - 1], stroke[i], stroke[i - 1].Length - fillets[i - 1].After, stroke[i].Length - fillets[i + 1].Before, bounds);
            }
        }

        var rounded = new List<PathPart>();
        for (var i = 0; i < stroke.Count; i++)
        {
            var (before, after) = (fillets[i], fillets[i + 1]);
            if (before.Radius > 0.0) rounded.Add(new PathPart(before.Arc.Length, before.Radius, double.PositiveInfinity));
            var rest = stroke[i].Length - before.After - after.Before;
            if (rest < ShortestRest) continue;
            var turns = (before.Radius > 0.0 ? 0.0 : TurnBefore(stroke, i)) + (after.Radius > 0.0 ? 0.0 : TurnBefore(stroke, i + 1));
            rounded.Add(new PathPart(rest, RadiusOf(stroke[i], turns, bounds), before.Radius > 0.0 ? double.PositiveInfinity : Through(stroke, i, bounds)));
        }

        return rounded;

        double Share(int side, bool atEnd)
        {
            var (first, last, length) = (wanted[side].After, wanted[side + 1].Before, stroke[side].Length);
            return first + last <= length ? length : length * (atEnd ? last : first) / (first + last);
        }
    }

    /// <summary>The stroke with its corners.</summary>
    public static IReadOnlyList<PathPart> Sharp(IReadOnlyList<PathElement> stroke, MotionBounds bounds) =>
    [
        .. stroke.Select((element, i) =>
            new PathPart(element.Length, RadiusOf(element, TurnBefore(stroke, i) + TurnBefore(stroke, i + 1), bounds), Through(stroke, i, bounds))),
    ];

    private static double TurnBefore(IReadOnlyList<PathElement> stroke, int element) =>
        element == 0 || element == stroke.Count ? 0.0 : Math.Abs(stroke[element - 1].LastTangent.TurnTo(stroke[element].FirstTangent));

    private static double Through(IReadOnlyList<PathElement> stroke, int element, MotionBounds bounds) =>
        element == 0 ? 0.0 : bounds.ThroughCorner(TurnBefore(stroke, element), (stroke[element - 1].Length + stroke[element].Length) / 2.0);

    /// <summary>Lines with corners so close that a sample covers several of them approximate an arc.</summary>
    private static double RadiusOf(in PathElement element, double turns, MotionBounds bounds) =>
        !element.IsLine || element.Length > bounds.Feed * MotionBounds.Sample || turns < SmallestTurn ? element.Radius : 2.0 * element.Length / turns;

    private static Fillet Largest(in PathElement before, in PathElement after, double mostBefore, double mostAfter, MotionBounds bounds)
    {
        var turn = before.LastTangent.TurnTo(after.FirstTangent);
        var through = bounds.ThroughCorner(turn, (before.Length + after.Length) / 2.0);
        if (through >= Math.Min(bounds.OnArc(before.Radius), bounds.OnArc(after.Radius))) return default;
        var corner = after.From;
        var (low, high, best) = (0.0, mostBefore, default(Fillet));
        var longest = Of(before, after, turn, high);
        if (Fits(longest)) best = longest;
        else
        {
            for (var i = 0; i < Halvings; i++)
            {
                var middle = (low + high) / 2.0;
                var found = Of(before, after, turn, middle);
                if (Fits(found)) (low, best) = (middle, found);
                else high = middle;
            }
        }

        return best.Radius >= bounds.SmallestRadius && bounds.OnArc(best.Radius) > SameSpeed * through ? best : default;

        bool Fits(Fillet fillet) => fillet.Radius > 0.0 && fillet.After <= mostAfter && fillet.Arc.Length > 0.0 && Deviation(fillet) <= bounds.Tolerance;
        double Deviation(Fillet fillet) => Math.Abs((fillet.Arc.Centre - corner).Length - fillet.Radius);
    }

    /// <summary>The arc that begins a length before the corner; its radius is not above 0 where there is none.</summary>
    private static Fillet Of(in PathElement before, in PathElement after, double turn, double length)
    {
        var side = turn > 0.0 ? 1.0 : -1.0;
        var (place, tangent) = (before.PointAt(before.Length - length), before.TangentAt(before.Length - length));
        var normal = tangent.Left * side;
        var (radius, replaced, last) = after.IsLine ? ToLine(after, place, normal, side) : ToArc(after, place, normal, side);
        if (!(radius > 0.0) || !double.IsFinite(radius)) return default;
        var sweep = side * tangent.TurnTo(last);
        if (sweep <= 0.0) return default;
        var centre = place + (normal * radius);
        return new Fillet(radius, length, replaced, PathElement.Arc(centre, radius, Math.Atan2(-normal.Y, -normal.X), side * sweep));
    }

    private static (double Radius, double Replaced, Plane Tangent) ToLine(in PathElement after, Plane place, Plane normal, double side)
    {
        var tangent = after.FirstTangent;
        var inwards = tangent.Left * side;
        var radius = (place - after.From).Dot(inwards) / (1.0 - normal.Dot(inwards));
        return (radius, (place + (normal * radius) - after.From).Dot(tangent), tangent);
    }

    private static (double Radius, double Replaced, Plane Tangent) ToArc(in PathElement after, Plane place, Plane normal, double side)
    {
        var inside = side * Math.Sign(after.Sweep); // 1: both arcs bend to the same side
        var to = place - after.Centre;
        var radius = ((after.Radius * after.Radius) - to.Dot(to)) / (2.0 * (normal.Dot(to) + (inside * after.Radius)));
        var spoke = (place + (normal * radius) - after.Centre) * (inside > 0.0 && radius > after.Radius ? -1.0 : 1.0);
        var swept = Math.Sign(after.Sweep) * Plane.At(after.Start).TurnTo(spoke);
        if (swept < -1e-9) swept += Math.Tau;
        var along = Math.Max(0.0, swept) * after.Radius;
        return (radius, along, after.TangentAt(along));
    }
}
