using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Motion.Planning;

namespace Engraver.Galil.Programs.Generation;

/// <summary>A line or an arc of the path in counts that are not rounded yet.</summary>
/// <param name="Shape">In plan; no free curve.</param>
/// <param name="StartZ">Height at its start, whole counts.</param>
/// <param name="EndZ">Height at its end.</param>
/// <param name="Entity">Drawing entity; of several the first.</param>
/// <param name="Move">Index in the toolpath's stroke; of several the first.</param>
/// <param name="Feed">Largest speed, counts/s.</param>
internal readonly record struct PathCourse(Segment Shape, int StartZ, int EndZ, int Entity, int Move, double Feed)
{
    /// <summary>The machine stops before it.</summary>
    public bool IsAfterStop { get; init; }

    /// <summary>It continues the curve of the course before it: the joint is not a corner of the drawing.</summary>
    public bool ContinuesCurve { get; init; }

    /// <summary>Number of consecutive moves that became this course.</summary>
    public int Moves { get; init; } = 1;

    /// <summary>As <see cref="VectorSegment.Shares"/>, from the start of the course.</summary>
    public IReadOnlyList<EntityShare>? Shares { get; init; }

    /// <summary>A corner at its start may replace this length, counts: that of its first move.</summary>
    public double StartPart { get; init; } = double.PositiveInfinity;

    /// <summary>The same at its end.</summary>
    public double EndPart { get; init; } = double.PositiveInfinity;

    public bool IsLine => Shape.Kind == SegmentKind.Line;

    public bool IsLevel => StartZ == EndZ;

    public double Length => IsLevel ? Shape.Length : double.Hypot(Shape.Length, (double)EndZ - StartZ);

    public double Radius => IsLine ? double.PositiveInfinity : Shape.Arc.Radius;

    public PathDirection StartDirection => IsLevel ? PathDirection.Of(Shape.StartTangent) : Slope;

    public PathDirection EndDirection => IsLevel ? PathDirection.Of(Shape.EndTangent) : Slope;

    private PathDirection Slope => PathDirection.Of(Shape.End.X - Shape.Start.X, Shape.End.Y - Shape.Start.Y, (double)EndZ - StartZ);

    /// <summary>The same course without a length at its start and at its end, counts.</summary>
    public PathCourse Trimmed(double atStart, double atEnd)
    {
        if (atStart == 0.0 && atEnd == 0.0) return this;
        var length = Shape.Length;
        var shares = EntityShare.Between(Shares, atStart, length - atEnd);
        var kept = this with { Shares = shares is { Count: > 1 } ? shares : null, Entity = shares is { } some ? some[0].EntityIndex : Entity };
        var (first, last) = (atStart / length, Math.Max(atStart / length, (length - atEnd) / length));
        if (IsLine) return kept with { Shape = Segment.FromLine(atStart == 0.0 ? Shape.Start : Shape.PointAt(first), atEnd == 0.0 ? Shape.End : Shape.PointAt(last)) };
        var arc = Shape.Arc;
        return kept with { Shape = Segment.FromArc(arc with { Start = arc.Start + (arc.Sweep * first), Sweep = arc.Sweep * (last - first) }, Shape.PointAt(first), atEnd == 0.0 ? Shape.End : Shape.PointAt(last)) };
    }
}
