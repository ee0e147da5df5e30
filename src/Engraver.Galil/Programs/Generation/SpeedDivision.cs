using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Motion.Planning;

namespace Engraver.Galil.Programs.Generation;

/// <summary>The segments of a sequence with the speeds of a plan. Where it brakes inside a segment, the segment is divided there.</summary>
/// <param name="planner">Has planned them.</param>
/// <param name="quantum">Resolution of angles.</param>
internal sealed class SpeedDivision(SpeedPlanner planner, AngleQuantum quantum)
{
    private int _slowest;

    /// <summary>The highest speed of a segment, counts/s.</summary>
    public int Fastest { get; private set; }

    /// <summary>Every segment has the same speed: it is that of the sequence, and none has to state it.</summary>
    public bool IsUniform => _slowest == Fastest;

    /// <param name="segments">As they were planned.</param>
    /// <param name="start">Where the first of them begins.</param>
    /// <param name="add">Receives each segment as it is sent, and whether the same segment continues after it.</param>
    public void Divide(IReadOnlyList<VectorSegment> segments, CountsPoint start, Action<VectorSegment, bool> add)
    {
        (_slowest, Fastest) = (int.MaxValue, 0);
        var (from, height) = (new Point2D(start.X, start.Y), start.Z);
        for (var i = 0; i < segments.Count; i++)
        {
            var (speeds, segment) = (planner.SpeedsOf(i), segments[i]);
            if (speeds.Second != 0 && PartsOf(segment, from, height, speeds.Braking) is { } parts) Add(segment, parts, speeds, add);
            else Add(segment, speeds.Second == 0 ? speeds.First : speeds.FirstFor(0.0, planner.Acceleration), false, add);
            (from, height) = (EndOf(segment, from), segment.End.Z);
        }
    }

    /// <summary>Where the controller is after a segment: whole counts after VP, the exact end point after CR.</summary>
    /// <param name="from">Where it is before it.</param>
    private static Point2D EndOf(in VectorSegment segment, Point2D from) =>
        segment.Kind == VectorSegmentKind.Line ? new Point2D(segment.End.X, segment.End.Y) : new ArcPrediction(from, segment.Radius, segment.ThetaDegrees, segment.DeltaDegrees).End;

    /// <summary>A segment that cuts these entities.</summary>
    public static VectorSegment WithShares(in VectorSegment segment, IReadOnlyList<EntityShare>? shares) =>
        shares is null ? segment : segment with { EntityIndex = shares[0].EntityIndex, Shares = shares.Count > 1 ? shares : null };

    private (VectorSegment First, VectorSegment Last)? PartsOf(in VectorSegment segment, Point2D from, int height, double braking) =>
        segment.Kind == VectorSegmentKind.Line ? SegmentDivision.Line(from, height, segment, braking) : SegmentDivision.Arc(from, segment, braking, quantum);

    private void Add(in VectorSegment segment, (VectorSegment First, VectorSegment Last) parts, SegmentSpeeds speeds, Action<VectorSegment, bool> add)
    {
        var place = parts.First.Length;
        Add(WithShares(parts.First, EntityShare.Between(segment.Shares, 0.0, place)), speeds.FirstFor(parts.Last.Length, planner.Acceleration), true, add);
        Add(WithShares(parts.Last, EntityShare.Between(segment.Shares, place, place + parts.Last.Length)), speeds.Second, false, add);
    }

    private void Add(in VectorSegment segment, int speed, bool goesOn, Action<VectorSegment, bool> add)
    {
        (_slowest, Fastest) = (Math.Min(_slowest, speed), Math.Max(Fastest, speed));
        add(segment with { Speed = speed }, goesOn);
    }
}
