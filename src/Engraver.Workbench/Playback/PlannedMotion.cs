using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Motion;
using Engraver.Core.Toolpaths;

namespace Engraver.Workbench.Playback;

/// <summary>The planned motion over time, exactly as computed by <c>plan</c>. Immutable; every query takes logarithmic time in the number of
/// segments.</summary>
public sealed class PlannedMotion
{
    /// <summary>Tolerance for the end of a segment, counts: far less than the length of the shortest segment.</summary>
    private const double EndTolerance = 1e-3;

    private readonly MotionTimeline _timeline;
    private readonly MotionProgram _program;

    /// <summary>Path length from the start of its sequence to the end of each segment, counts.</summary>
    private readonly double[] _lengths;

    /// <summary>For each stroke the index of its first sequence among all strokes, plus one final entry.</summary>
    private readonly int[] _firstSequences;

    /// <summary>For each sequence of the program: the index of its first segment.</summary>
    private readonly int[] _firstSegments;

    private readonly SegmentMoves _moves;

    /// <summary>Row of each move; null if the numbers are equal.</summary>
    private readonly int[]? _rows;
    private readonly Lazy<int[]> _lines;

    /// <summary>By drawing entity its first move that is cut. Created on demand.</summary>
    private readonly Lazy<Dictionary<int, int>> _moveOfEntity;

    /// <summary>By move of the toolpath its first segment plus one; 0 for none. Created on demand.</summary>
    private readonly Lazy<int[]> _segmentOfMove;

    /// <summary>The profile of the last query; replaced as a whole, so that any thread may query.</summary>
    private volatile SequenceProfileOf? _profile;

    private PlannedMotion(MotionTimeline timeline, SegmentMoves moves, int[]? rows, Func<IReadOnlyList<int>>? lines)
    {
        _timeline = timeline;
        _program = timeline.Program;
        (_moves, _rows, _lines) = (moves, rows, new Lazy<int[]>(() => [.. lines?.Invoke() ?? []]));
        _lengths = new double[moves.Count];
        _firstSequences = new int[_program.Strokes.Count + 1];
        for (var stroke = 0; stroke < _program.Strokes.Count; stroke++) _firstSequences[stroke + 1] = _firstSequences[stroke] + _program.Strokes[stroke].Sequences.Count;
        _firstSegments = new int[_firstSequences[^1]];
        NumberSegments();
        _moveOfEntity = new Lazy<Dictionary<int, int>>(MovesOfEntities);
        _segmentOfMove = new Lazy<int[]>(FirstSegments);
    }

    public double DurationSeconds => _timeline.Seconds;

    public int SegmentCount => _moves.Count;

    /// <summary>The spans of time, for plots.</summary>
    public MotionTimeline Timeline => _timeline;

    /// <param name="program">Generated from <paramref name="path"/>.</param>
    /// <param name="commands">Command times of the controller.</param>
    /// <param name="lines">Returns the lines of the posted program, one for each segment, on the first query of a line; null if there is none.</param>
    public static PlannedMotion Create(MotionProgram program, Toolpath path, CommandTimes commands, Func<IReadOnlyList<int>>? lines, CancellationToken cancellation)
    {
        var timeline = MotionTimeline.From(program, commands, cancellation);
        var (moves, rows) = (SegmentMoves.Map(program, path), SegmentMoves.RowsOf(path));
        cancellation.ThrowIfCancellationRequested();
        return new PlannedMotion(timeline, moves, rows, lines);
    }

    /// <summary>The motion at a time, limited to its range. A job with nothing to cut is at its start.</summary>
    public PlaybackMoment At(double seconds)
    {
        var index = _timeline.SpanAt(seconds);
        if (index < 0) return new PlaybackMoment(0.0, Millimetres(_program.Start.X, _program.Start.Y), 0.0, false, MotionSpanKind.Dwell, -1, -1, -1, -1, -1);
        var span = _timeline.Spans[index];
        var since = Math.Clamp(seconds - span.Start, 0.0, span.Seconds);
        return span.Kind switch
        {
            MotionSpanKind.Cut => Cutting(span, since),
            MotionSpanKind.Rapid => Rapid(span, since),
            _ => Moment(span, since, FirstSegment(span.Stroke, span.Sequence) + SegmentOffset(span), Millimetres(span.From.X, span.From.Y), 0.0),
        };
    }

    /// <summary>Start time of the first segment of a drawing entity; null if it is not cut.</summary>
    public double? TimeOfEntity(int entity) => _moveOfEntity.Value.TryGetValue(entity, out var move) ? TimeOfMove(move) : null;

    /// <summary>The spans of time in which any of these drawing entities is cut, in their order. Takes linear time.</summary>
    public IReadOnlyList<(double Start, double End)> TimesOf(IReadOnlyCollection<int> entities)
    {
        ArgumentNullException.ThrowIfNull(entities);
        var wanted = entities.ToHashSet();
        var first = wanted.Min(entity => _moveOfEntity.Value.TryGetValue(entity, out var move) ? First(_segmentOfMove.Value, move) : null) ?? int.MaxValue;
        var (times, start) = (new List<(double, double)>(), -1.0);
        for (var number = 0; number < _firstSegments.Length; number++)
        {
            var end = number + 1 < _firstSegments.Length ? _firstSegments[number + 1] : SegmentCount;
            for (var segment = Math.Max(first, _firstSegments[number]); segment < end; segment++)
            {
                for (var move = _moves.FirstOf(segment); move <= _moves.LastOf(segment); move++)
                {
                    var isOfEntity = wanted.Contains(_moves.EntityOf(move));
                    if (isOfEntity == start >= 0.0) continue;
                    var at = TimeAlong(segment, _moves.StartOf(segment, move) * SegmentAt(segment).Length);
                    if (!isOfEntity) times.Add((start, at));
                    start = isOfEntity ? at : -1.0;
                }
            }

            if (start < 0.0) continue;
            times.Add((start, _timeline.CutOf(number).End));
            start = -1.0;
        }

        return times;
    }

    /// <summary>Start time of the first segment of a row of the sequenced table; null if the row is shorter than a count.</summary>
    public double? TimeOfRow(int row)
    {
        if (_rows is null) return TimeOfMove(row);
        var move = Array.BinarySearch(_rows, row);
        while (move > 0 && _rows[move - 1] == row) move--;
        for (; move >= 0 && move < _rows.Length && _rows[move] == row; move++)
        {
            if (TimeOfMove(move) is { } seconds) return seconds;
        }

        return null;
    }

    /// <summary>Start time of the first segment of a move of the toolpath; null if the move is shorter than a count.</summary>
    /// <param name="move">Index in the whole toolpath.</param>
    public double? TimeOfMove(int move) => First(_segmentOfMove.Value, move) is { } segment ? TimeAlong(segment, _moves.StartOf(segment, move) * SegmentAt(segment).Length) : null;

    /// <summary>The line of the posted program that commands a segment, 1 is first; 0 if no program was posted. The first query posts it.</summary>
    public int LineOf(int segment) => (uint)segment < (uint)_lines.Value.Length ? _lines.Value[segment] : 0;

    /// <summary>Start time of the first segment of a line of the posted program, or of the next line with a segment; null after the last.</summary>
    public double? TimeOfLine(int line)
    {
        var lines = _lines.Value;
        var at = Array.BinarySearch(lines, line);
        if (at < 0) at = ~at;
        while (at > 0 && at < lines.Length && lines[at - 1] == line) at--;
        return at < Math.Min(lines.Length, SegmentCount) ? TimeOfSegment(at) : null;
    }

    /// <summary>Start time of cutting a stroke; null if the motion has no such stroke.</summary>
    /// <param name="stroke">Its index in the order of cutting.</param>
    public double? TimeOfStroke(int stroke)
    {
        var (low, high) = (0, _program.Strokes.Count - 1);
        while (low <= high)
        {
            var middle = (low + high) / 2;
            var index = _program.Strokes[middle].Index;
            if (index == stroke) return _timeline.CutOf(_firstSequences[middle]).Start;
            if (index < stroke) low = middle + 1;
            else high = middle - 1;
        }

        return null;
    }

    /// <summary>Start time of a segment of the motion program.</summary>
    public double TimeOfSegment(int segment) => TimeAlong(segment, 0.0);

    /// <summary>Time at which the tool is at the point of a segment nearest to a position.</summary>
    /// <param name="place">Drawing millimetres.</param>
    public double TimeOfPlace(int segment, Point2D place)
    {
        var (stroke, sequence) = PlaceOf(segment);
        var (cut, first) = (_program.Strokes[stroke].Sequences[sequence], FirstSegment(stroke, sequence));
        var (part, from) = (cut.Segments[segment - first], segment == first ? cut.Start : cut.Segments[segment - first - 1].End);
        return TimeAlong(segment, part.Length * SegmentPosition.FractionNear(part, from, _program.Profile.Scale.Exact(place)));
    }

    /// <param name="along">Length from the start of the segment, counts.</param>
    private double TimeAlong(int segment, double along)
    {
        var (stroke, sequence) = PlaceOf(segment);
        var reached = segment == FirstSegment(stroke, sequence) ? 0.0 : _lengths[segment - 1];
        return _timeline.CutOf(_firstSequences[stroke] + sequence).Start + ProfileOf(stroke, sequence).SecondsAt(reached + along);
    }

    /// <summary>The speed profile of one sequence, counts. That of the last query is kept: the next one is mostly of the same sequence.</summary>
    internal SequenceProfile ProfileOf(int stroke, int sequence)
    {
        if (_profile is not { } last || last.Stroke != stroke || last.Sequence != sequence) _profile = last = new SequenceProfileOf(stroke, sequence, SequenceProfile.Of(_program.Strokes[stroke].Sequences[sequence], _program.Profile));
        return last.Profile;
    }

    private void NumberSegments()
    {
        var (next, number) = (0, 0);
        foreach (var sequences in _program.Strokes.Select(stroke => stroke.Sequences))
        {
            for (var sequence = 0; sequence < sequences.Count; sequence++)
            {
                _firstSegments[number++] = next;
                var (segments, length) = (sequences[sequence].Segments, 0.0);
                for (var i = 0; i < segments.Count; i++) _lengths[next++] = length += segments[i].Length;
            }
        }
    }

    private Dictionary<int, int> MovesOfEntities()
    {
        var moves = new Dictionary<int, int>();
        for (var move = 0; move < _segmentOfMove.Value.Length; move++)
        {
            if (_segmentOfMove.Value[move] != 0) moves.TryAdd(_moves.EntityOf(move), move);
        }

        return moves;
    }

    /// <summary>For each move its first segment plus one. With several passes moves repeat.</summary>
    private int[] FirstSegments()
    {
        var first = new int[_moves.Count == 0 ? 0 : Enumerable.Range(0, _moves.Count).Max(_moves.LastOf) + 1];
        for (var segment = 0; segment < _moves.Count; segment++)
        {
            for (var move = _moves.FirstOf(segment); move <= _moves.LastOf(segment); move++)
            {
                if (first[move] == 0) first[move] = segment + 1;
            }
        }

        return first;
    }

    private int RowOf(int move) => _rows is null ? move : _rows[move];

    private static int? First(int[] segments, int of) => (uint)of < (uint)segments.Length && segments[of] is > 0 and var place ? place - 1 : null;

    private int FirstSegment(int stroke, int sequence) => _firstSegments[_firstSequences[stroke] + sequence];

    private VectorSegment SegmentAt(int segment)
    {
        var (stroke, sequence) = PlaceOf(segment);
        return _program.Strokes[stroke].Sequences[sequence].Segments[segment - FirstSegment(stroke, sequence)];
    }

    private (int Stroke, int Sequence) PlaceOf(int segment)
    {
        var sequence = Array.BinarySearch(_firstSegments, segment);
        if (sequence < 0) sequence = ~sequence - 1;
        var stroke = Array.BinarySearch(_firstSequences, sequence);
        if (stroke < 0) stroke = ~stroke - 1;
        return (stroke, sequence - _firstSequences[stroke]);
    }

    private PlaybackMoment Cutting(in MotionSpan span, double since)
    {
        var sequence = _program.Strokes[span.Stroke].Sequences[span.Sequence];
        var profile = ProfileOf(span.Stroke, span.Sequence);
        var path = profile.PathAt(since);
        var first = FirstSegment(span.Stroke, span.Sequence);
        var found = Array.BinarySearch(_lengths, first, sequence.Segments.Count, path);
        var (segment, last) = (found >= 0 ? found + 1 : ~found, first + sequence.Segments.Count - 1);
        while (segment < last && _lengths[segment] - path < EndTolerance) segment++; // The start time of a segment belongs to that segment despite rounding of time and distance.
        segment = Math.Min(segment, last);
        var from = segment == first ? sequence.Start : sequence.Segments[segment - first - 1].End;
        var done = Math.Max(0.0, path - (segment == first ? 0.0 : _lengths[segment - 1]));
        var cut = sequence.Segments[segment - first];
        var place = SegmentPosition.At(cut, from, cut.Length > 0.0 ? done / cut.Length : 1.0);
        var speed = SegmentPosition.Millimetres(cut, from, done, profile.SpeedAfter(since), _program.Profile.Scale);
        return Moment(span, since, segment, Millimetres(place.X, place.Y), speed, done);
    }

    private PlaybackMoment Rapid(in MotionSpan span, double since)
    {
        var axes = _timeline.RapidOf(span);
        var (x, y) = (axes[0], axes[1]);
        var place = Millimetres(
            span.From.X + (Math.Sign((long)span.To.X - span.From.X) * x.DistanceAt(since)),
            span.From.Y + (Math.Sign((long)span.To.Y - span.From.Y) * y.DistanceAt(since)));
        var speed = Millimetres(x.SpeedAt(since), y.SpeedAt(since)).DistanceTo(default);
        return Moment(span, since, FirstSegment(span.Stroke, 0) + SegmentOffset(span), place, speed);
    }

    /// <summary>Index in its stroke of the segment to which a standstill or rapid belongs: the settle at the end of a stroke and the rapid to the finish belong
    /// to the segment before, all others to the segment after.</summary>
    private int SegmentOffset(in MotionSpan span)
    {
        var sequence = _program.Strokes[span.Stroke].Sequences[span.Sequence];
        if (span.ToolOn || span.Start < _timeline.CutOf(_firstSequences[span.Stroke] + span.Sequence).End - 1e-12) return 0;
        var first = span.Kind == MotionSpanKind.Rapid ? FirstSegment(span.Stroke, span.Sequence) - FirstSegment(span.Stroke, 0) : 0;
        return first + sequence.Segments.Count - 1;
    }

    /// <param name="along">Length from the start of the segment, counts.</param>
    private PlaybackMoment Moment(in MotionSpan span, double since, int segment, Point2D place, double speed, double along = 0.0)
    {
        var cut = SegmentAt(segment);
        var move = _moves.At(segment, cut.Length > 0.0 ? (along + EndTolerance) / cut.Length : 0.0);
        return new PlaybackMoment(span.Start + since, place, speed, span.ToolOn, span.Kind, _program.Strokes[span.Stroke].Index, segment, _moves.EntityOf(move), move, RowOf(move));
    }

    private Point2D Millimetres(double x, double y) => _program.Profile.Scale.ToMillimetres(x, y);

    private sealed record SequenceProfileOf(int Stroke, int Sequence, SequenceProfile Profile);
}
