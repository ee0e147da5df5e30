using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Motion.Planning;

namespace Engraver.Galil.Programs.Generation;

/// <summary>The segments of a sequence with the speeds of a plan. Where it brakes inside a segment, the segment is divided there.</summary>
/// <param name="planner">Has planned them.</param>
/// <param name="quantum">Resolution of angles.</param>
internal sealed class SpeedDivision(SpeedPlanner planner, AngleQuantum quantum)
{
    private readonly List<VectorSegment> _planned = [];
    private readonly List<int> _divided = [];

    /// <summary>The segments as they are sent.</summary>
    public IReadOnlyList<VectorSegment> Planned => _planned;

    /// <summary>Those of them after which the same segment goes on.</summary>
    public IReadOnlyList<int> Divided => _divided;

    /// <summary>The highest speed of a segment, counts/s.</summary>
    public int Fastest { get; private set; }

    /// <param name="segments">As they were planned.</param>
    /// <param name="starts">The exact start of each.</param>
    /// <param name="height">Height at the first start, counts.</param>
    public void Divide(IReadOnlyList<VectorSegment> segments, IReadOnlyList<Point2D> starts, int height)
    {
        _planned.Clear();
        _divided.Clear();
        Fastest = 0;
        for (var i = 0; i < segments.Count; i++)
        {
            var (speeds, segment) = (planner.SpeedsOf(i), segments[i]);
            if (speeds.Second == 0 || !Divide(segment, starts[i], height, speeds)) _planned.Add(segment with { Speed = speeds.Second == 0 ? speeds.First : speeds.FirstFor(0.0, planner.Acceleration) });
            height = segment.End.Z;
        }

        foreach (var segment in _planned) Fastest = Math.Max(Fastest, segment.Speed);
        if (_planned.TrueForAll(segment => segment.Speed == Fastest))
        {
            for (var i = 0; i < _planned.Count; i++) _planned[i] = _planned[i] with { Speed = 0 };
        }
    }

    /// <summary>A segment that cuts these entities.</summary>
    public static VectorSegment WithShares(in VectorSegment segment, IReadOnlyList<EntityShare>? shares) =>
        shares is null ? segment : segment with { EntityIndex = shares[0].EntityIndex, Shares = shares.Count > 1 ? shares : null };

    private bool Divide(in VectorSegment segment, Point2D from, int height, SegmentSpeeds speeds)
    {
        if ((segment.Kind == VectorSegmentKind.Line ? SegmentDivision.Line(from, height, segment, speeds.Braking) : SegmentDivision.Arc(from, segment, speeds.Braking, quantum)) is not { } parts) return false;
        var place = parts.First.Length;
        _divided.Add(_planned.Count);
        _planned.Add(WithShares(parts.First, EntityShare.Between(segment.Shares, 0.0, place)) with { Speed = speeds.FirstFor(parts.Last.Length, planner.Acceleration) });
        _planned.Add(WithShares(parts.Last, EntityShare.Between(segment.Shares, place, place + parts.Last.Length)) with { Speed = speeds.Second });
        return true;
    }
}
