using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Motion;
using Engraver.Workbench.Playback;

namespace Engraver.Workbench.Plots;

/// <summary>Speed and acceleration of the planned motion, at every place where they change.</summary>
public static class PlannedSeries
{
    /// <summary>Default maximum number of samples.</summary>
    public const int MaxSamples = 1_000_000;

    private const double SecondsPerMinute = 60.0;

    private const double Percent = 100.0;

    /// <summary>Largest angle of an arc between two samples, degrees: the acceleration of an axis changes by less than a tenth of its amplitude.</summary>
    private const double ArcStepDegrees = 5.0;

    private const int PartsOfArcInRamp = 4;

    /// <summary>Number of parts of a ramp of a rapid, where the speeds of two axes are combined.</summary>
    private const int PartsOfRamp = 8;

    /// <param name="linkLoad">Load of the link by a sequence, 0 to 1; null for a link without a limit.</param>
    /// <param name="maxSamples">At least 8.</param>
    public static MotionSeries From(PlannedMotion motion, Func<VectorSequence, double?>? linkLoad, int maxSamples, CancellationToken cancellation)
    {
        ArgumentNullException.ThrowIfNull(motion);
        ArgumentOutOfRangeException.ThrowIfLessThan(maxSamples, 8);
        var walk = new Walk(motion.Timeline, linkLoad, new SeriesBuilder(maxSamples));
        foreach (var span in motion.Timeline.Spans)
        {
            cancellation.ThrowIfCancellationRequested();
            walk.Add(span);
        }

        return walk.ToSeries();
    }

    private sealed class Walk(MotionTimeline timeline, Func<VectorSequence, double?>? linkLoad, SeriesBuilder samples)
    {
        private readonly MotionProgram _program = timeline.Program;
        private readonly CountsScale _scale = timeline.Program.Profile.Scale;
        private readonly double _restLoad = linkLoad is null ? double.NaN : 0.0;
        private double _path;
        private double _load;

        public MotionSeries ToSeries() => samples.ToSeries();

        public void Add(in MotionSpan span)
        {
            switch (span.Kind)
            {
                case MotionSpanKind.Cut:
                    AddCut(span);
                    break;
                case MotionSpanKind.Rapid:
                    AddRapid(span);
                    break;
                default:
                    AddAtRest(span);
                    break;
            }
        }

        private VectorSequence SequenceOf(in MotionSpan span) => _program.Strokes[span.Stroke].Sequences[span.Sequence];

        private int EntityOf(in MotionSpan span) => SequenceOf(span).Segments is { Count: > 0 } segments ? segments[0].EntityIndex : -1;

        private void AddAtRest(in MotionSpan span)
        {
            var entity = EntityOf(span);
            samples.Add(new PlannedSample(span.Start, _path, entity, 0.0, 0.0, 0.0, _restLoad));
            samples.Add(new PlannedSample(span.End, _path, entity, 0.0, 0.0, 0.0, _restLoad));
        }

        /// <summary>Each axis runs its own trapezoid; the samples are at the corners of both and between them.</summary>
        private void AddRapid(in MotionSpan span)
        {
            var axes = timeline.RapidOf(span);
            var directions = new Vector2D(Math.Sign((long)span.To.X - span.From.X), Math.Sign((long)span.To.Y - span.From.Y));
            var entity = EntityOf(span);
            var end = span.Seconds;
            var corners = axes.SelectMany(CornersOf).Append(end).Where(at => at <= end).Distinct().Order().ToList();
            var last = default(Vector2D);
            for (var i = 1; i < corners.Count; i++)
            {
                var (from, to) = (corners[i - 1], corners[i]);
                var acceleration = _scale.ToMillimetres(new Vector2D(directions.X * GainOf(axes[0], (from + to) / 2.0), directions.Y * GainOf(axes[1], (from + to) / 2.0)));
                for (var part = 0; part <= PartsOfRamp; part++)
                {
                    var at = from + ((to - from) * part / PartsOfRamp);
                    var travelled = _scale.ToMillimetres(new Vector2D(axes[0].DistanceAt(at), axes[1].DistanceAt(at)));
                    _path += (travelled - last).Length;
                    last = travelled;
                    var speed = _scale.ToMillimetres(new Vector2D(axes[0].SpeedAt(at), axes[1].SpeedAt(at))).Length;
                    samples.Add(new PlannedSample(span.Start + at, _path, entity, speed * SecondsPerMinute, acceleration.X, acceleration.Y, _restLoad));
                }
            }
        }

        private static IEnumerable<double> CornersOf(SpeedTrapezoid axis) => axis.Distance > 0.0 ? [0.0, axis.RampSeconds, axis.Seconds - axis.RampSeconds, axis.Seconds] : [0.0];

        /// <summary>Acceleration of one axis, counts/s2; 0 at constant speed and after its end.</summary>
        private static double GainOf(SpeedTrapezoid axis, double at) => at < axis.RampSeconds ? axis.Acceleration : at > axis.Seconds ? 0.0 : at > axis.Seconds - axis.RampSeconds ? -axis.Acceleration : 0.0;

        private void AddCut(in MotionSpan span)
        {
            var sequence = SequenceOf(span);
            _load = linkLoad?.Invoke(sequence) is { } load ? load * Percent : double.NaN;
            var profile = SequenceProfile.Of(sequence, _program.Profile);
            var kinematics = new SequenceKinematics(profile, _scale);
            var (start, from, change) = (0.0, sequence.Start, 0);
            foreach (var segment in sequence.Segments)
            {
                var parts = Math.Max(1, (int)Math.Ceiling(Math.Abs(segment.DeltaDegrees) / ArcStepDegrees));
                var at = 0.0;
                for (var part = 1; part <= parts; part++)
                {
                    var end = segment.Length * part / parts;
                    while (at < end - 1e-9)
                    {
                        while (change < profile.Changes.Count && profile.Changes[change] - start <= at + 1e-9) change++;
                        var to = change < profile.Changes.Count ? Math.Min(end, profile.Changes[change] - start) : end;
                        AddPiece(span, profile, kinematics, new PieceOfSegment(segment, from, start, at, to), isRamp: profile.GainAt(start + ((at + to) / 2.0)) != 0.0);
                        at = to;
                    }
                }

                start += segment.Length;
                from = segment.End;
            }
        }

        /// <summary>A piece in which the acceleration along the path does not change. In an arc that is cut while the speed changes, that of an axis
        /// is not linear in time, so the piece is divided.</summary>
        private void AddPiece(in MotionSpan span, SequenceProfile profile, SequenceKinematics kinematics, in PieceOfSegment piece, bool isRamp)
        {
            var (start, inside) = (piece.SegmentStart, piece.SegmentStart + ((piece.At + piece.End) / 2.0));
            AddSample(span, profile, kinematics, piece, piece.At, inside);
            var (at, from, to) = (piece.At, profile.SecondsAt(start + piece.At), profile.SecondsAt(start + piece.End));
            var parts = isRamp && piece.Segment.Kind == VectorSegmentKind.Arc ? PartsOfArcInRamp : 1;
            for (var part = 1; part <= parts; part++)
            {
                var end = part == parts ? piece.End : Math.Clamp(profile.PathAt(from + ((to - from) * part / parts)) - start, at, piece.End);
                _path += _scale.ToMillimetres(SequenceKinematics.Direction(piece.Segment, piece.From, (at + end) / 2.0 / piece.Segment.Length) * (end - at)).Length;
                AddSample(span, profile, kinematics, piece, end, inside);
                at = end;
            }
        }

        /// <param name="at">Place on the segment, counts from its start.</param>
        /// <param name="inside">A place of the sequence inside the piece, where the acceleration along the path is taken: at its ends it changes.</param>
        private void AddSample(in MotionSpan span, SequenceProfile profile, SequenceKinematics kinematics, in PieceOfSegment piece, double at, double inside)
        {
            var (path, fraction) = (piece.SegmentStart + at, at / piece.Segment.Length);
            var seconds = Math.Min(span.Start + profile.SecondsAt(path), span.End);
            var speed = kinematics.VelocityAt(piece.Segment, piece.From, fraction, path).Length;
            var acceleration = kinematics.AccelerationAt(piece.Segment, piece.From, fraction, path, inside);
            samples.Add(new PlannedSample(seconds, _path, piece.Segment.EntityAt(at), speed * SecondsPerMinute, acceleration.X, acceleration.Y, _load));
        }
    }

    /// <summary>A part of a segment, in counts.</summary>
    /// <param name="From">Start of the segment.</param>
    /// <param name="SegmentStart">Length of the sequence before the segment.</param>
    /// <param name="At">Start of the part, from the start of the segment.</param>
    /// <param name="End">End of the part.</param>
    private readonly record struct PieceOfSegment(VectorSegment Segment, CountsPoint From, double SegmentStart, double At, double End);
}
