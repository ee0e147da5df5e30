using Engraver.Core.Geometry;
using Engraver.Core.Machines;

namespace Engraver.Core.Motion;

/// <summary>The rest of a motion program from a place on: a separate program, and its position in the whole one.</summary>
/// <remarks>It keeps the planned speeds and accelerations: from rest it is nowhere faster than planned. Where it begins on an arc, the acceleration along the
/// path is added there to that across it, at most the square root of two times the limit, as in a hold.</remarks>
/// <param name="Program">The rest. Its first stroke may begin in the middle of the whole program's, a lead-in before the place.</param>
/// <param name="StrokesBefore">Strokes of the whole program before the first of the rest.</param>
/// <param name="SequencesBefore">Sequences of that stroke before the first of the rest.</param>
/// <param name="SegmentsBefore">Segments of the whole program before the first of the rest, in the order of cutting.</param>
/// <param name="CutLengthOfFirst">Counts of the whole program's segment that are before the first segment of the rest.</param>
public sealed record RemainingProgram(MotionProgram Program, int StrokesBefore, int SequencesBefore, int SegmentsBefore, double CutLengthOfFirst)
{
    /// <summary>The rest may begin this much earlier, counts, where a point of whole counts is nearer to the path.</summary>
    public const double WholeCountSearch = 8.0;

    /// <summary>An arc shorter than this is not cut alone, counts.</summary>
    private const double ShortestRest = 2.0;

    /// <summary>Nothing was cut yet.</summary>
    public static RemainingProgram Whole(MotionProgram program) => new(program, 0, 0, 0, 0.0);

    /// <summary>The rest of a program.</summary>
    /// <param name="place">Everything before it is cut.</param>
    /// <param name="leadIn">Counts of the path before the place, in the same stroke, that are cut again; 0 for none.</param>
    /// <param name="keepAngle">The angle that the controller keeps for an angle sent to it, degrees.</param>
    public static RemainingProgram From(MotionProgram program, JobPosition place, double leadIn, Func<double, double> keepAngle)
    {
        ArgumentNullException.ThrowIfNull(program);
        ArgumentNullException.ThrowIfNull(keepAngle);
        ArgumentOutOfRangeException.ThrowIfNegative(leadIn);
        var (stroke, first) = StrokeOf(program, place.Segments);
        if (stroke == program.Strokes.Count) return new RemainingProgram(program with { Strokes = [] }, stroke, 0, first, 0.0);
        var part = new RemainingStroke(program.Strokes[stroke], keepAngle).From(new JobPosition(place.Segments - first, place.Along), leadIn);
        if (part.Stroke is null) return new RemainingProgram(program with { Strokes = [.. program.Strokes.Skip(stroke + 1)] }, stroke + 1, 0, first + SegmentsOf(program.Strokes[stroke]), 0.0);
        return new RemainingProgram(program with { Strokes = [part.Stroke, .. program.Strokes.Skip(stroke + 1)] }, stroke, part.Sequences, first + part.Segments, part.Along);
    }

    internal static int SegmentsOf(MotionStroke stroke) => stroke.Sequences.Sum(sequence => sequence.Segments.Count);

    /// <summary>The stroke that holds a segment, and its first segment.</summary>
    private static (int Stroke, int First) StrokeOf(MotionProgram program, int segment)
    {
        var first = 0;
        for (var stroke = 0; stroke < program.Strokes.Count; stroke++)
        {
            var count = SegmentsOf(program.Strokes[stroke]);
            if (segment < first + count) return (stroke, first);
            first += count;
        }

        return (program.Strokes.Count, first);
    }

    /// <summary>Divides one stroke in two on its path.</summary>
    private sealed class RemainingStroke(MotionStroke stroke, Func<double, double> keepAngle)
    {
        private readonly List<(int Sequence, CountsPoint Start, VectorSegment Segment)> _segments = [.. Flat(stroke)];

        /// <returns>The rest of the stroke, with the sequences and segments of it before the rest and the counts of the first segment; null when nothing is
        /// left.</returns>
        public (MotionStroke? Stroke, int Sequences, int Segments, double Along) From(JobPosition place, double leadIn)
        {
            var (at, along) = Back(place, leadIn);
            if (at == _segments.Count) return (null, 0, at, 0.0);
            if (along == 0.0) return (Rest(at, _segments[at].Start, _segments[at].Segment), _segments[at].Sequence, at, 0.0);
            (along, var start) = WholeCount(at, along);
            var (_, _, segment) = _segments[at];
            if (Shortened(segment, along, start) is { } rest) return (Rest(at, start, rest), _segments[at].Sequence, at, along);
            return at + 1 < _segments.Count ? (Rest(at + 1, _segments[at + 1].Start, _segments[at + 1].Segment), _segments[at + 1].Sequence, at + 1, 0.0) : (null, 0, at + 1, 0.0);
        }

        private static IEnumerable<(int Sequence, CountsPoint Start, VectorSegment Segment)> Flat(MotionStroke stroke)
        {
            for (var i = 0; i < stroke.Sequences.Count; i++)
            {
                var start = stroke.Sequences[i].Start;
                foreach (var segment in stroke.Sequences[i].Segments)
                {
                    yield return (i, start, segment);
                    start = segment.End;
                }
            }
        }

        /// <summary>The place one lead-in earlier on the path, not before the stroke's start.</summary>
        private (int At, double Along) Back(JobPosition place, double leadIn)
        {
            var (at, along) = (place.Segments, Math.Min(place.Along, _segments[place.Segments].Segment.Length));
            var left = leadIn;
            while (left > along && at > 0)
            {
                left -= along;
                along = _segments[--at].Segment.Length;
            }

            along = Math.Max(0.0, along - left);
            var length = _segments[at].Segment.Length;
            if (leadIn == 0.0 && along >= length - 0.5) return (at + 1, 0.0);
            along = Math.Min(along, length - ShortestRest);
            return (at, along < ShortestRest ? 0.0 : along);
        }

        /// <summary>The point of whole counts nearest to the path, a little earlier on it.</summary>
        private (double Along, CountsPoint Start) WholeCount(int at, double along)
        {
            var course = new SegmentPath(_segments[at].Start, _segments[at].Segment);
            var (best, start, off) = (along, _segments[at].Start, double.PositiveInfinity);
            for (var back = 0.0; back <= WholeCountSearch && along - back >= ShortestRest; back += 0.5)
            {
                var whole = CountsScale.Round(course.At(along - back)) with { Z = HeightAt(at, along - back) };
                var away = course.DistanceTo(new Point2D(whole.X, whole.Y));
                if (away >= off - 0.05) continue;
                (best, start, off) = (along - back, whole, away);
            }

            return (best, start);
        }

        /// <summary>A line may rise or fall; an arc does not change its height.</summary>
        private int HeightAt(int at, double along)
        {
            var (_, start, segment) = _segments[at];
            return start.Z == segment.End.Z ? start.Z : (int)Math.Round(start.Z + (((double)segment.End.Z - start.Z) * along / segment.Length), MidpointRounding.AwayFromZero);
        }

        /// <summary>The rest of a segment from a place on it; null when it has no length in counts.</summary>
        private VectorSegment? Shortened(in VectorSegment segment, double along, CountsPoint start)
        {
            var left = segment.Length - along;
            var shares = EntityShare.Between(segment.Shares, along, segment.Length);
            var kept = segment with { EntityIndex = segment.EntityAt(along), Shares = shares is { Count: > 1 } ? shares : null };
            if (segment.Kind == VectorSegmentKind.Line) return start == segment.End ? null : kept with { Length = start.Z == segment.End.Z ? new Point2D(start.X, start.Y).DistanceTo(new Point2D(segment.End.X, segment.End.Y)) : left };
            var part = along / segment.Length;
            var theta = keepAngle(Angle.FromDegrees(segment.ThetaDegrees + (part * segment.DeltaDegrees)).Positive().Degrees);
            var delta = keepAngle((1.0 - part) * segment.DeltaDegrees);
            if (delta == 0.0) return null;
            var arc = kept with { ThetaDegrees = theta, DeltaDegrees = delta, Length = left };
            return arc with { End = CountsScale.Round(new SegmentPath(start, arc).At(left)) with { Z = segment.End.Z } };
        }

        /// <summary>The rest from a segment on. Where the first one ends beside its planned end, the arcs after it are shifted by the same distance, until a
        /// line ends at its planned end again.</summary>
        private MotionStroke Rest(int at, CountsPoint start, VectorSegment first)
        {
            var sequences = new List<VectorSequence>();
            var (begin, shift) = (start, (X: first.End.X - _segments[at].Segment.End.X, Y: first.End.Y - _segments[at].Segment.End.Y));
            for (var sequence = _segments[at].Sequence; sequence < stroke.Sequences.Count; sequence++)
            {
                var segments = new List<VectorSegment>();
                for (var i = at; i < _segments.Count && _segments[i].Sequence == sequence; i++, at++)
                {
                    var segment = segments.Count == 0 && sequences.Count == 0 ? first : _segments[i].Segment;
                    if (segments.Count > 0 || sequences.Count > 0)
                    {
                        if (segment.Kind == VectorSegmentKind.Line) shift = default;
                        else segment = segment with { End = segment.End with { X = segment.End.X + shift.X, Y = segment.End.Y + shift.Y } };
                    }

                    segments.Add(segment);
                }

                sequences.Add(stroke.Sequences[sequence] with { Start = begin, Segments = segments });
                begin = segments[^1].End;
            }

            return stroke with { Start = start, Sequences = sequences };
        }
    }
}
