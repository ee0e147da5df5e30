namespace Engraver.Core.Geometry.Biarcs;

/// <summary>Collects the arcs of a fit; neighbours on one circle become one arc, neighbours on one line one line.</summary>
internal sealed class ArcChain
{
    /// <summary>Arcs whose radii and centres differ by less than this part of the radius are on the same circle.</summary>
    private const double SameCircle = 1e-9;

    /// <summary>Sine of the largest angle between two lines that are joined into one.</summary>
    private const double SameDirection = 1e-12;

    private readonly List<Segment> _segments = [];

    public void Add(in TangentArc arc)
    {
        if (arc.Start != arc.End) Add(arc.ToSegment());
    }

    public IReadOnlyList<Segment> ToSegments() => _segments;

    private void Add(Segment next)
    {
        if (_segments.Count > 0 && Joined(_segments[^1], next) is { } joined) _segments[^1] = joined;
        else _segments.Add(next);
    }

    private static Segment? Joined(Segment last, Segment next)
    {
        if (last.Kind != next.Kind || last.End != next.Start) return null;
        if (last.Kind == SegmentKind.Line)
        {
            return Math.Abs(last.StartTangent.Cross(next.StartTangent)) <= SameDirection && last.StartTangent.Dot(next.StartTangent) > 0.0 ? Segment.FromLine(last.Start, next.End) : null;
        }

        return last.Kind == SegmentKind.Arc ? OnOneCircle(last, next) : null;
    }

    /// <summary>The arc that covers both, when they are on one circle. A whole turn only if it ends exactly at its start; null when it would end near its start
    /// but not exactly there.</summary>
    private static Segment? OnOneCircle(Segment last, Segment next)
    {
        var (a, b) = (last.Arc, next.Arc);
        var within = SameCircle * a.Radius;
        if (Math.Abs(a.Radius - b.Radius) > within || !a.Centre.IsNear(b.Centre, within) || a.Sweep.Degrees * b.Sweep.Degrees < 0.0) return null;
        var sweep = a.Sweep + b.Sweep;
        var isWhole = last.Start == next.End && Math.Abs(Math.Abs(sweep.Degrees) - 360.0) < 1e-6;
        if (isWhole) return Segment.FromArc(a with { Sweep = Angle.FullTurn * Math.Sign(sweep.Degrees) }, last.Start, next.End);
        return Math.Abs(sweep.Degrees) <= 350.0 ? Segment.FromArc(a with { Sweep = sweep }, last.Start, next.End) : null;
    }
}
