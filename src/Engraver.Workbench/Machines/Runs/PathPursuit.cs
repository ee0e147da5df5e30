using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Motion;

namespace Engraver.Workbench.Machines.Runs;

/// <summary>Follows the positions of a run along its motion program, in the order of cutting.</summary>
internal sealed class PathPursuit(MotionProgram program)
{
    /// <summary>A position farther from the path is not on it, counts.</summary>
    private const double OnPath = 3.0;

    /// <summary>Positions without a place after which the whole program is searched: a run may begin in the middle.</summary>
    private const int Patience = 20;

    private SegmentCursor _at = new(program);
    private SequenceProfile? _profile;
    private (int Stroke, int Sequence) _profiled = (-1, -1);
    private int _missed;

    /// <summary>The place of a position.</summary>
    /// <param name="counts">Job frame.</param>
    /// <param name="following">Distance of the motors from their commanded position, counts.</param>
    /// <param name="reach">Longest way since the last position, counts.</param>
    /// <returns>Null where it is not on the path ahead.</returns>
    public PursuedPlace? Find(Point2D counts, double following, double reach)
    {
        var tolerance = OnPath + following;
        var isLost = _missed >= Patience;
        var found = Search(isLost ? new SegmentCursor(program) : _at, counts, tolerance, isLost ? double.PositiveInfinity : reach + (2.0 * tolerance));
        _missed = found is null && !isLost ? _missed + 1 : 0;
        if (found is not { } cursor) return null;
        _at = cursor;
        return Planned();
    }

    private static SegmentCursor? Search(SegmentCursor from, Point2D counts, double tolerance, double reach)
    {
        var (ahead, isFirst) = (0.0, true);
        for (var cursor = from; cursor.IsInside && ahead <= reach; cursor = cursor.Next())
        {
            var path = cursor.Path;
            if (path.DistanceTo(counts) <= tolerance)
            {
                var along = path.LengthTo(counts, tolerance);
                if (!isFirst) return cursor with { Along = along };
                if (along < from.Along - tolerance && EndOf(cursor.Segment).DistanceTo(counts) <= tolerance) along = cursor.Segment.Length; // of a whole turn
                if (along >= from.Along - tolerance) return cursor with { Along = Math.Max(along, from.Along) };
            }

            ahead += cursor.Segment.Length - (isFirst ? from.Along : 0.0);
            isFirst = false;
        }

        return null;
    }

    private static Point2D EndOf(in VectorSegment segment) => new(segment.End.X, segment.End.Y);

    private PursuedPlace Planned()
    {
        if (_profile is null || _profiled != (_at.Stroke, _at.Sequence)) (_profile, _profiled) = (SequenceProfile.Of(_at.Whole, program.Profile), (_at.Stroke, _at.Sequence));
        var path = _at.Before + _at.Along;
        return new PursuedPlace(_profiled, _at.Segment.EntityAt(_at.Along), path, _profile.Length - path, _profile.SecondsAt(path), _profile.SpeedAt(path));
    }

    /// <summary>A place on a segment of the program.</summary>
    private readonly record struct SegmentCursor
    {
        private readonly MotionProgram _program;

        public SegmentCursor(MotionProgram program)
        {
            _program = program;
            if (program.Strokes.Count > 0) (Whole, Start) = (program.Strokes[0].Sequences[0], program.Strokes[0].Sequences[0].Start);
        }

        public int Stroke { get; private init; }

        public int Sequence { get; private init; }

        /// <summary>Index of the segment in its sequence.</summary>
        public int Index { get; private init; }

        public VectorSequence Whole { get; private init; } = null!;

        public CountsPoint Start { get; private init; }

        /// <summary>Length of the sequence before the segment, counts.</summary>
        public double Before { get; private init; }

        /// <summary>Length from the start of the segment, counts.</summary>
        public double Along { get; init; }

        public bool IsInside => Stroke < _program.Strokes.Count;

        public VectorSegment Segment => Whole.Segments[Index];

        public SegmentPath Path => new(Start, Segment);

        public SegmentCursor Next()
        {
            if (Index + 1 < Whole.Segments.Count) return this with { Index = Index + 1, Start = Segment.End, Before = Before + Segment.Length, Along = 0.0 };
            var (stroke, sequence) = Sequence + 1 < _program.Strokes[Stroke].Sequences.Count ? (Stroke, Sequence + 1) : (Stroke + 1, 0);
            if (stroke >= _program.Strokes.Count) return this with { Stroke = stroke };
            var whole = _program.Strokes[stroke].Sequences[sequence];
            return this with { Stroke = stroke, Sequence = sequence, Whole = whole, Index = 0, Start = whole.Start, Before = 0.0, Along = 0.0 };
        }
    }
}

/// <summary>A place on a sequence with its plan.</summary>
/// <param name="Sequence">Indices of stroke and sequence.</param>
/// <param name="Entity">Drawing entity.</param>
/// <param name="Path">Length from the start of the sequence, counts.</param>
/// <param name="Left">Length to its end, counts.</param>
/// <param name="Seconds">Planned time from the start of the sequence.</param>
/// <param name="Speed">Planned, counts/s.</param>
internal readonly record struct PursuedPlace((int Stroke, int Sequence) Sequence, int Entity, double Path, double Left, double Seconds, double Speed);
