using Engraver.Core.Geometry;

namespace Engraver.Core.Trajectories;

/// <summary>Divides a contour at its corners.</summary>
internal static class ContourRuns
{
    /// <summary>Largest gap between two segments without a bridging line, as a fraction of the allowed error.</summary>
    private const double GapShare = 0.1;

    /// <summary>Largest value of t (1 - t)^2, the cubic with slope 1 at one end of a unit length and 0 at the other.</summary>
    private const double LargestBulge = 4.0 / 27.0;

    /// <summary>Runs in the order of travel; for a closed contour with corners, the first starts at a corner.</summary>
    public static IEnumerable<(IReadOnlyList<Segment> Segments, bool Closed)> Split(IReadOnlyList<Segment> contour, bool closed, CornerMode mode, double maxError)
    {
        var segments = Joined(contour, closed, GapShare * maxError);
        if (segments.Count == 0) return [];
        var corners = mode == CornerMode.Stop ? Corners(segments, closed, maxError) : [];
        if (corners.Count == 0) return [(segments, closed)];
        var runs = new List<(IReadOnlyList<Segment>, bool)>();
        if (!closed) corners = [0, .. corners, segments.Count];
        else corners.Add(corners[0] + segments.Count);
        for (var i = 0; i + 1 < corners.Count; i++) runs.Add(([.. Enumerable.Range(corners[i], corners[i + 1] - corners[i]).Select(index => segments[index % segments.Count])], false));
        return runs;
    }

    /// <summary>Segments without zero-length ones, with splines cut where their spans meet at an angle, and with a line in every relevant gap.</summary>
    private static List<Segment> Joined(IReadOnlyList<Segment> contour, bool closed, double gap)
    {
        var joined = new List<Segment>();
        foreach (var segment in contour.SelectMany(Smooth).Where(segment => segment.Length > 0.0))
        {
            if (joined.Count > 0 && joined[^1].End.DistanceTo(segment.Start) > gap) joined.Add(Segment.FromLine(joined[^1].End, segment.Start));
            joined.Add(segment);
        }

        if (closed && joined.Count > 0 && joined[^1].End.DistanceTo(joined[0].Start) > gap) joined.Add(Segment.FromLine(joined[^1].End, joined[0].Start));
        return joined;
    }

    private static IEnumerable<Segment> Smooth(Segment segment)
    {
        if (!segment.IsFreeCurve) return [segment];
        var (spans, parts, first) = (segment.Curve.Spans.ToArray(), new List<Segment>(), 0);
        for (var i = 1; i <= spans.Length; i++)
        {
            if (i < spans.Length && !IsCorner(spans[i - 1].EndTangent, spans[i].StartTangent)) continue;
            parts.Add(first == 0 && i == spans.Length ? segment : Segment.FromCurve(new RationalCurve(segment.Kind, spans[first..i])));
            first = i;
        }

        return parts;
    }

    private static List<int> Corners(List<Segment> segments, bool closed, double maxError)
    {
        var corners = new List<int>();
        for (var i = closed ? 0 : 1; i < segments.Count; i++)
        {
            var (before, after) = (segments[(i + segments.Count - 1) % segments.Count], segments[i]);
            if (IsCorner(before.EndTangent, after.StartTangent) || Bulge(before, after) > maxError) corners.Add(i);
        }

        return corners;
    }

    /// <summary>Deviation of a line that is run without a stop at a bend of this turn, mm: a cubic element as long as the line, turned from it at one end.
    /// Lines are not divided.</summary>
    private static double Bulge(Segment before, Segment after)
    {
        var line = Math.Max(before.Kind == SegmentKind.Line ? before.Length : 0.0, after.Kind == SegmentKind.Line ? after.Length : 0.0);
        return line * before.EndTangent.TurnTo(after.StartTangent).Abs().Radians * LargestBulge;
    }

    private static bool IsCorner(Vector2D arriving, Vector2D leaving) => arriving.TurnTo(leaving).Abs().Degrees > ChainJoint.CornerDegrees;
}
