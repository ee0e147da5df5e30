using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Verification;

namespace Engraver.Workbench.Machines.Runs;

/// <summary>How much slower than planned the machine ran along its path, and where. Only the cutting itself is compared: the time at rest before and after a
/// sequence is that of the commands.</summary>
/// <param name="Seconds">Sum of what was lost and gained.</param>
/// <param name="Places">Where most was lost, at most five, most first.</param>
/// <param name="Behind">For each place of the trace the time lost so far, seconds; NaN while the machine did not cut.</param>
public sealed record RunLag(double Seconds, IReadOnlyList<LagPlace> Places, IReadOnlyList<double> Behind)
{
    private const int MaxPlaces = 5;

    /// <summary>Programs with more segments are not compared.</summary>
    private const int MaxSegments = 200_000;

    /// <summary>Shortest time between two positions that are compared, seconds: positions are whole counts.</summary>
    private const double MinStep = 0.01;

    /// <summary>A machine this near to the start or the end of a sequence is at rest there, counts.</summary>
    private const double AtRest = 1.0;

    /// <summary>Part of the planned time, and seconds, that must be lost between two positions of a slow part.</summary>
    private const double SlowShare = 0.02;
    private const double SlowSeconds = 0.0005;

    /// <summary>Slow parts with less are not worth a line.</summary>
    private const double WorthSeconds = 0.02;

    /// <param name="program">As it was run, job frame.</param>
    /// <param name="trace">Of the motors or of polled positions.</param>
    /// <returns>Null where nothing can be compared.</returns>
    public static RunLag? Of(MotionProgram program, RunTrace trace)
    {
        ArgumentNullException.ThrowIfNull(program);
        ArgumentNullException.ThrowIfNull(trace);
        if (program.SegmentCount is 0 or > MaxSegments || trace.Places.Count == 0) return null;
        var walk = new Walk(program);
        var behind = new double[trace.Places.Count];
        for (var i = 0; i < behind.Length; i++) behind[i] = walk.Add(trace.Places[i]);
        return walk.IsKnown ? new RunLag(walk.Lost, walk.Slowest(), behind) : null;
    }

    private sealed class Walk(MotionProgram program)
    {
        private readonly PathPursuit _pursuit = new(program);
        private readonly CountsScale _scale = program.Profile.Scale;
        private readonly List<LagPlace> _slow = [];
        private readonly double _fastest = program.Strokes.SelectMany(stroke => stroke.Sequences).Max(sequence => sequence.Speed);
        private (RunTracePlace Seen, PursuedPlace Planned)? _last;
        private SlowPart _part;
        private double _speed = double.NaN;

        public double Lost { get; private set; }

        public bool IsKnown { get; private set; }

        /// <returns>Time lost so far; NaN while the machine does not cut.</returns>
        public double Add(in RunTracePlace seen)
        {
            if (!seen.ToolOn)
            {
                Break();
                return double.NaN;
            }

            var waited = _last is { } last ? seen.Seconds - last.Seen.Seconds : 0.0;
            var counts = _scale.Exact(seen.Place);
            var reach = ((_last is null ? MinStep : waited) * 2.0 * _fastest) + 10.0;
            if (_pursuit.Find(counts, _scale.Finer.CountsOf(seen.FollowingMm ?? 0.0), reach) is not { } planned)
            {
                Break();
                return double.NaN;
            }

            if (_last is { } before && before.Planned.Sequence == planned.Sequence)
            {
                if (IsResting(before.Planned)) End();
                else if (waited < MinStep && planned.Left > AtRest) return Lost;
                else Compare(before, (seen, planned), waited);
            }
            else
            {
                End();
            }

            _last = (seen, planned);
            return Lost;
        }

        public IReadOnlyList<LagPlace> Slowest()
        {
            End();
            return [.. _slow.OrderByDescending(place => place.Seconds).Take(MaxPlaces)];
        }

        /// <summary>The machine was at rest before the path or after it, for an unknown time: the tool settles.</summary>
        private static bool IsResting(in PursuedPlace before) => before.Path <= AtRest || before.Left <= AtRest;

        private void Compare((RunTracePlace Seen, PursuedPlace Planned) before, (RunTracePlace Seen, PursuedPlace Planned) now, double took)
        {
            IsKnown = true;
            var ratio = now.Seen.Conditions.FeedRatio is > 0.0 and var overridden ? overridden : 1.0;
            var planned = (now.Planned.Seconds - before.Planned.Seconds) / ratio;
            var (lost, way) = (took - planned, now.Planned.Path - before.Planned.Path);
            Lost += lost;
            var speed = way / took;
            if (lost > (SlowShare * planned) + SlowSeconds)
            {
                if (_part.Took == 0.0) _part = new SlowPart(before.Seen.Place, before.Planned.Entity);
                _part.Add(took, planned, way, double.IsNaN(_speed) ? 0.0 : Math.Abs(speed - _speed), Math.Abs(now.Planned.Speed - before.Planned.Speed));
            }
            else
            {
                End();
            }

            _speed = speed;
        }

        private void Break()
        {
            End();
            _last = null;
            _speed = double.NaN;
        }

        private void End()
        {
            if (_part.Lost >= WorthSeconds) _slow.Add(_part.ToPlace(_scale));
            _part = default;
        }
    }

    /// <summary>A part that is slower than planned, while it lasts.</summary>
    private record struct SlowPart(Point2D Place, int Entity)
    {
        private double _planned;
        private double _way;
        private double _changed;
        private double _plannedChange;

        public double Took { get; private set; }

        public readonly double Lost => Took - _planned;

        public void Add(double took, double planned, double way, double changed, double plannedChange)
        {
            Took += took;
            (_planned, _way, _changed, _plannedChange) = (_planned + planned, _way + way, _changed + changed, _plannedChange + plannedChange);
        }

        public readonly LagPlace ToPlace(CountsScale scale)
        {
            double Rate(double counts, double seconds) => seconds > 0.0 ? scale.Coarser.LengthOf(counts / seconds) : 0.0;
            return new LagPlace(Place, Entity, Lost, Rate(_way, _planned), Rate(_way, Took), Rate(_plannedChange, _planned), Rate(_changed, Took));
        }
    }
}
