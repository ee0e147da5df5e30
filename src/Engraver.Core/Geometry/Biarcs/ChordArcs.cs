namespace Engraver.Core.Geometry.Biarcs;

/// <summary>Replaces chords that draw a curve by few arcs and lines, each tangent to the one before.</summary>
/// <remarks>
/// From a vertex and a direction there is one arc to each later vertex. Of the vertices that it reaches within the tolerance, it ends at the one from which the
/// next arc reaches farthest. The directions at these vertices are then beside those of the curve by as much as is best for single arcs: where the curvature
/// changes by c for each unit of length, an arc within e is (125 e / c)^(1/3) long, and one of a pair with the curve's own directions (40 e / c)^(1/3).
/// </remarks>
/// <param name="tolerance">Largest distance between chords and arcs, in both directions.</param>
/// <param name="smallestRadius">Of an arc, same unit.</param>
/// <param name="largestRadius">A larger arc is a line.</param>
public sealed class ChordArcs(double tolerance, double smallestRadius, double largestRadius)
{
    /// <summary>Sine of the largest angle between the last arc and the direction in which the path continues.</summary>
    private const double SameDirection = 2e-3;

    private const double LargestSweepDegrees = 300.0;

    /// <summary>Where two arcs reach less than this part of what the two before reached, two with another direction are tried.</summary>
    private const double FarReach = 0.75;

    /// <summary>Chords at the start from whose vertices the first direction is taken; the one with the farthest reach counts.</summary>
    private static readonly int[] s_firstChords = [1, 2, 4, 8, 16];

    /// <summary>Parts of the reach at which an arc may end.</summary>
    private static readonly double[] s_parts = [1.0, 0.95, 0.9, 0.85, 0.8, 0.72, 0.64, 0.55];

    /// <summary>Arcs and lines from the first vertex to the last.</summary>
    /// <param name="vertices">Ends of the chords, at least two, no two consecutive ones equal.</param>
    /// <param name="leaving">Direction at the first vertex, length 1; null for any.</param>
    /// <param name="arriving">Direction in which the path continues after the last vertex; null for any. Where no arcs within the tolerance have it, they end
    /// with another one.</param>
    public IReadOnlyList<ChordArc> Cover(ReadOnlySpan<Point2D> vertices, Vector2D? leaving, Vector2D? arriving)
    {
        if (leaving is null && arriving is { } end) return Backwards(vertices, end);
        var (arcs, from, last, step) = (new List<ChordArc>(), 0, vertices.Length - 1, 1);
        var (tangent, before) = (leaving ?? FirstDirection(vertices), leaving is null ? 0 : last);
        while (from < last)
        {
            var next = Next(vertices, from, tangent, step);
            if (next.Reach < last && next.Reach - from < FarReach * before && Turned(vertices, from, tangent, next.Reach) is { } turned)
            {
                arcs.AddRange(turned);
                (from, tangent, before) = (turned[^1].To, turned[^1].Arc.EndTangent, 0);
                continue;
            }

            before = next.Reach - from;
            if (arriving is { } wanted && next.Reach == last && Finish(vertices, from, tangent, next, wanted) is { } finish)
            {
                arcs.AddRange(finish);
                break;
            }

            arcs.Add(next.Arc);
            step = Math.Max(1, (next.Arc.To - from) / 2);
            (from, tangent) = (next.Arc.To, next.Arc.Arc.EndTangent);
        }

        return arcs;
    }

    /// <summary>Two arcs to the direction of the curve, where two arcs from vertex to vertex are short because the first direction is too far beside it: on a
    /// circle it would remain so.</summary>
    /// <param name="reach">Of two arcs from vertex to vertex.</param>
    /// <returns>Null where they and the next arc do not reach farther for each arc.</returns>
    private ChordArc[]? Turned(ReadOnlySpan<Point2D> vertices, int from, Vector2D tangent, int reach)
    {
        var (best, far, last) = (default(ChordArc[]), from + ((reach - from) * 3 / 2), vertices.Length - 1);
        for (var chords = 2; from + chords < last; chords += Math.Max(1, chords / 2))
        {
            var to = from + chords;
            if (DirectionAt(vertices, to, Math.Min(chords, last - to)) is not { } direction || Pair(vertices[..(to + 1)], from, tangent, direction) is not { } pair) break;
            if (Longest(vertices, to, direction, chords).To is var reached && reached > far) (best, far) = (pair, reached);
        }

        return best;
    }

    /// <summary>Direction of the circle through a vertex and two others at a number of chords from it.</summary>
    private static Vector2D? DirectionAt(ReadOnlySpan<Point2D> vertices, int at, int chords)
    {
        var (first, second) = (vertices[at] - vertices[at - chords], vertices[at + chords] - vertices[at]);
        if (!(first.Length > 0.0) || !(second.Length > 0.0)) return null;
        return Vector2D.FromPolar(1.0, first.Direction + (first.TurnTo(second) * (first.Length / (first.Length + second.Length))));
    }

    private List<ChordArc> Backwards(ReadOnlySpan<Point2D> vertices, Vector2D arriving)
    {
        var (turned, last) = (vertices.ToArray(), vertices.Length - 1);
        Array.Reverse(turned);
        return [.. Cover(turned, -arriving, null).Reverse().Select(arc => new ChordArc(arc.Arc.Reversed(), last - arc.To, last - arc.From))];
    }

    /// <summary>The tangent of the circle through three vertices.</summary>
    private Vector2D FirstDirection(ReadOnlySpan<Point2D> vertices)
    {
        var (best, farthest) = ((vertices[1] - vertices[0]) * (1.0 / vertices[0].DistanceTo(vertices[1])), -1);
        foreach (var chords in s_firstChords)
        {
            if (2 * chords >= vertices.Length) break;
            var (first, second) = (vertices[chords] - vertices[0], vertices[2 * chords] - vertices[chords]);
            if (!(first.Length > 0.0) || !(second.Length > 0.0)) continue;
            var turn = first.TurnTo(second) * (first.Length / (first.Length + second.Length));
            var tangent = Vector2D.FromPolar(1.0, first.Direction - turn);
            if (Next(vertices, 0, tangent, 1).Reach is var reach && reach > farthest) (best, farthest) = (tangent, reach);
        }

        return best;
    }

    /// <summary>The arc that begins at a vertex, and the vertex that the one after it reaches.</summary>
    private (ChordArc Arc, int Reach) Next(ReadOnlySpan<Point2D> vertices, int from, Vector2D tangent, int step)
    {
        var longest = Longest(vertices, from, tangent, step);
        if (longest.To == vertices.Length - 1) return (longest, longest.To);
        var (best, farthest, before) = (longest, -1, -1);
        foreach (var part in s_parts)
        {
            var to = from + Math.Max(1, (int)Math.Round((longest.To - from) * part));
            if (to == before) continue;
            before = to;
            if ((to == longest.To ? longest.Arc : Between(vertices, from, tangent, to)) is not { } arc) continue;
            var reach = Longest(vertices, to, arc.EndTangent, Math.Max(1, (longest.To - from) / 2)).To;
            if (reach > farthest) (best, farthest) = (new ChordArc(arc, from, to), reach);
        }

        return (best, farthest);
    }

    /// <summary>The longest arc; the chord itself where there is none.</summary>
    private ChordArc Longest(ReadOnlySpan<Point2D> vertices, int from, Vector2D tangent, int step)
    {
        var (good, bad, best, last) = (from, int.MaxValue, default(TangentArc?), vertices.Length - 1);
        while (good < last && bad == int.MaxValue)
        {
            var to = Math.Min(last, good + step);
            if (Between(vertices, from, tangent, to) is { } arc) (good, best, step) = (to, arc, 2 * step);
            else bad = to;
        }

        while (bad != int.MaxValue && bad - good > 1)
        {
            var to = good + ((bad - good) / 2);
            if (Between(vertices, from, tangent, to) is { } arc) (good, best) = (to, arc);
            else bad = to;
        }

        return best is { } found ? new ChordArc(found, from, good) : new ChordArc(TangentArc.Straight(vertices[from], vertices[from + 1]), from, from + 1);
    }

    /// <summary>The last arcs, with the direction in which the path continues: one, two tangent ones, or one and two.</summary>
    private ChordArc[]? Finish(ReadOnlySpan<Point2D> vertices, int from, Vector2D tangent, in (ChordArc Arc, int Reach) next, Vector2D wanted)
    {
        var last = vertices.Length - 1;
        if (Between(vertices, from, tangent, last) is { } whole && Continues(whole, wanted)) return [new ChordArc(whole, from, last)];
        if (Pair(vertices, from, tangent, wanted) is { } two) return two;
        var first = next.Arc;
        for (var part = 0; part < s_parts.Length && first.To - from > 1; part++)
        {
            var to = from + Math.Max(1, (int)((next.Arc.To - from) * s_parts[part]));
            if (Between(vertices, from, tangent, to) is not { } arc) continue;
            first = new ChordArc(arc, from, to);
            if (to == last) continue;
            if (Between(vertices, to, arc.EndTangent, last) is { } second && Continues(second, wanted)) return [first, new ChordArc(second, to, last)];
            if (Pair(vertices, to, arc.EndTangent, wanted) is { } rest) return [first, .. rest];
        }

        return null;
    }

    private static bool Continues(in TangentArc arc, Vector2D wanted) => Math.Abs(arc.EndTangent.Cross(wanted)) <= SameDirection && arc.EndTangent.Dot(wanted) > 0.0;

    /// <summary>Two arcs to the last vertex that meet anywhere on the chords.</summary>
    private ChordArc[]? Pair(ReadOnlySpan<Point2D> vertices, int from, Vector2D tangent, Vector2D wanted)
    {
        var last = vertices.Length - 1;
        if (Biarc.Between(vertices[from], tangent, vertices[last], wanted) is not { } pair || !IsLegal(pair.First) || !IsLegal(pair.Second)) return null;
        var (joint, at) = (pair.First.End, from);
        while (at + 1 < last && (joint - vertices[at + 1]).Dot(vertices[at + 1] - vertices[at]) > 0.0) at++;
        var chord = vertices[at + 1] - vertices[at];
        var on = vertices[at] + (chord * Math.Clamp((joint - vertices[at]).Dot(chord) / chord.LengthSquared, 0.0, 1.0));
        if (joint.DistanceTo(on) > tolerance) return null;
        if (!IsWithin([.. vertices[from..(at + 1)], on], pair.First) || !IsWithin([on, .. vertices[(at + 1)..]], pair.Second)) return null;
        return [new ChordArc(pair.First, from, Math.Min(at + 1, last - 1)), new ChordArc(pair.Second, Math.Min(at + 1, last - 1), last)];
    }

    /// <summary>The arc from a vertex to another one; null where there is none within the tolerance.</summary>
    private TangentArc? Between(ReadOnlySpan<Point2D> vertices, int from, Vector2D tangent, int to)
    {
        var arc = TangentArc.From(vertices[from], tangent, vertices[to]);
        if (Math.Abs(arc.Curvature) * largestRadius < 1.0) arc = TangentArc.Straight(vertices[from], vertices[to]);
        return IsLegal(arc) && IsWithin(vertices[from..(to + 1)], arc) ? arc : null;
    }

    private bool IsLegal(in TangentArc arc) => Math.Abs(arc.Curvature) * smallestRadius <= 1.0;

    /// <summary>True when no point of the chords is farther than the tolerance from the arc, they follow it forwards, and once. Arc and chords begin and end
    /// beside each other: no point of the arc is farther from them either.</summary>
    private bool IsWithin(ReadOnlySpan<Point2D> vertices, in TangentArc arc)
    {
        var (side, before, length) = (Math.Sign(arc.Curvature), Outside(vertices[0], arc), 0.0);
        for (var i = 1; i < vertices.Length; i++)
        {
            var (chord, way) = (vertices[i] - vertices[i - 1], vertices[i - 1] - arc.Start);
            var along = arc.StartTangent + (new Vector2D(-way.Y, way.X) * arc.Curvature);
            if (chord == default) continue;
            if (!(chord.Dot(along) > 0.0)) return false;
            var away = Outside(vertices[i], arc);
            if (!(Math.Abs(away) <= tolerance) || (side != 0 && !(Math.Abs(Inmost(chord.LengthSquared, before, away, Math.Abs(1.0 / arc.Curvature))) <= tolerance))) return false;
            length += chord.Length;
            before = away;
        }

        return side == 0 || IsOnce(length, arc);
    }

    private static bool IsOnce(double length, in TangentArc arc)
    {
        var way = arc.End - arc.Start;
        var sweep = Angle.FromRadians(2.0 * Math.Atan2(arc.StartTangent.Cross(way), arc.StartTangent.Dot(way))).Abs();
        var radius = Math.Abs(1.0 / arc.Curvature);
        return sweep.Degrees <= LargestSweepDegrees && Math.Abs(length - (radius * sweep.Radians)) < radius;
    }

    /// <summary>Distance of a place from the arc's circle, positive outside; from a line, positive on the right.</summary>
    private static double Outside(Point2D place, in TangentArc arc)
    {
        var distance = ArcDeviation.FromCircle(place, arc);
        var way = place - arc.Start;
        var isInside = (arc.Curvature * way.LengthSquared) - (2.0 * arc.StartTangent.Cross(way)) < 0.0 != arc.Curvature < 0.0;
        return isInside ? -distance : distance;
    }

    /// <summary>Distance from a circle of the point of a chord that is nearest to its centre, positive outside.</summary>
    /// <param name="squared">Square of the length of the chord.</param>
    /// <param name="start">Of its start.</param>
    /// <param name="end">Of its end.</param>
    private static double Inmost(double squared, double start, double end, double radius)
    {
        var half = Math.Sqrt(squared) / 2.0;
        var beside = (end - start) * ((2.0 * radius) + start + end) / (4.0 * half); // of the middle from the foot of the centre
        if (Math.Abs(beside) >= half) return Math.Min(start, end);
        var difference = (start * ((2.0 * radius) + start)) - ((half - beside) * (half - beside));
        return difference / (radius + Math.Sqrt(Math.Max(0.0, (radius * radius) + difference)));
    }
}
