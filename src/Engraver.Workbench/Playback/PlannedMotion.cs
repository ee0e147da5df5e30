using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Motion;
using Engraver.Core.Sequencing;

namespace Engraver.Workbench.Playback;

/// <summary>The planned motion in time, exactly as <c>plan</c> counts it. Immutable; every question is answered in the logarithm of the number of segments.</summary>
public sealed class PlannedMotion
{
    private readonly MotionTimeline _timeline;
    private readonly MotionProgram _program;

    /// <summary>Path length from the start of its sequence to the end of each segment, counts.</summary>
    private readonly double[] _reached;

    /// <summary>For each stroke, for each of its sequences: its first segment in the whole program.</summary>
    private readonly int[][] _firstSegments;

    /// <summary>For each stroke, for each of its sequences: the cutting span.</summary>
    private readonly int[][] _cutSpans;
    private readonly VectorSegment[] _segments;
    private readonly int[] _rows;
    private readonly int[] _lines;
    private readonly Dictionary<int, int> _segmentOfEntity = [];
    private readonly Dictionary<int, int> _segmentOfRow = [];

    private PlannedMotion(MotionTimeline timeline, int[] rows, int[] lines)
    {
        _timeline = timeline;
        _program = timeline.Program;
        (_rows, _lines) = (rows, lines);
        _segments = new VectorSegment[rows.Length];
        _reached = new double[rows.Length];
        _firstSegments = [.. _program.Strokes.Select(stroke => new int[stroke.Sequences.Count])];
        _cutSpans = [.. _program.Strokes.Select(stroke => new int[stroke.Sequences.Count])];
        NumberSegments();
        NumberSpans();
    }

    public double DurationSeconds => _timeline.Seconds;

    public int SegmentCount => _segments.Length;

    /// <summary>The spans of time, for plots.</summary>
    public MotionTimeline Timeline => _timeline;

    /// <param name="program">Generated from the strokes of <paramref name="sequence"/>.</param>
    /// <param name="commands">How the controller spends its time.</param>
    /// <param name="lines">Of the posted program, for the line under the tool: one for each segment; empty when there is none.</param>
    public static PlannedMotion Create(MotionProgram program, SequencingResult sequence, CommandTimes commands, IReadOnlyList<int> lines, CancellationToken cancellation)
    {
        var timeline = MotionTimeline.From(program, commands, cancellation);
        var rows = SegmentRows.Map(program, sequence);
        cancellation.ThrowIfCancellationRequested();
        return new PlannedMotion(timeline, rows, [.. lines]);
    }

    /// <summary>The motion at a moment; before 0 its beginning, after the end its end. A job with nothing to cut stands at its start.</summary>
    public PlaybackMoment At(double seconds)
    {
        var index = _timeline.SpanAt(seconds);
        if (index < 0) return new PlaybackMoment(0.0, Millimetres(_program.Start.X, _program.Start.Y), 0.0, false, MotionSpanKind.Dwell, -1, -1, -1, -1, 0);
        var span = _timeline.Spans[index];
        var since = Math.Clamp(seconds - span.Start, 0.0, span.Seconds);
        return span.Kind switch
        {
            MotionSpanKind.Cut => Cutting(span, since),
            MotionSpanKind.Rapid => Rapid(span, since),
            _ => Moment(span, since, _firstSegments[span.Stroke][span.Sequence] + StandsBehind(span), Millimetres(span.From.X, span.From.Y), 0.0),
        };
    }

    /// <summary>When the first segment of a drawing entity begins; null when it is not cut.</summary>
    public double? TimeOfEntity(int entity) => _segmentOfEntity.TryGetValue(entity, out var segment) ? TimeOfSegment(segment) : null;

    /// <summary>When the first segment of a row of the sequenced table begins; null when the row is shorter than a count.</summary>
    public double? TimeOfRow(int row) => _segmentOfRow.TryGetValue(row, out var segment) ? TimeOfSegment(segment) : null;

    /// <summary>When the first segment that a line of the posted program commands begins; of a line without one the next that has one; null behind the last.</summary>
    public double? TimeOfLine(int line)
    {
        var at = Array.BinarySearch(_lines, line);
        if (at < 0) at = ~at;
        while (at > 0 && at < _lines.Length && _lines[at - 1] == line) at--;
        return at < Math.Min(_lines.Length, _segments.Length) ? TimeOfSegment(at) : null;
    }

    /// <summary>When a stroke begins to be cut; null when there is no such stroke in the motion.</summary>
    /// <param name="stroke">Its index in the order of cutting.</param>
    public double? TimeOfStroke(int stroke)
    {
        var (low, high) = (0, _program.Strokes.Count - 1);
        while (low <= high)
        {
            var middle = (low + high) / 2;
            var index = _program.Strokes[middle].Index;
            if (index == stroke) return _timeline.Spans[_cutSpans[middle][0]].Start;
            if (index < stroke) low = middle + 1;
            else high = middle - 1;
        }

        return null;
    }

    /// <summary>When a segment of the motion program begins.</summary>
    public double TimeOfSegment(int segment)
    {
        var (stroke, sequence) = PlaceOf(segment);
        var span = _timeline.Spans[_cutSpans[stroke][sequence]];
        var before = segment == _firstSegments[stroke][sequence] ? 0.0 : _reached[segment - 1];
        return span.Start + TrapezoidOf(stroke, sequence).TimeAt(before);
    }

    /// <summary>The speed profile of one sequence, counts.</summary>
    internal SpeedTrapezoid TrapezoidOf(int stroke, int sequence)
    {
        var cut = _program.Strokes[stroke].Sequences[sequence];
        return new SpeedTrapezoid(_reached[_firstSegments[stroke][sequence] + cut.Segments.Count - 1], cut.Speed, _program.Profile.AccelerationCounts);
    }

    private void NumberSegments()
    {
        var next = 0;
        for (var stroke = 0; stroke < _program.Strokes.Count; stroke++)
        {
            var sequences = _program.Strokes[stroke].Sequences;
            for (var i = 0; i < sequences.Count; i++)
            {
                _firstSegments[stroke][i] = next;
                var length = 0.0;
                foreach (var segment in sequences[i].Segments)
                {
                    _segments[next] = segment;
                    _reached[next] = length += segment.Length;
                    _segmentOfEntity.TryAdd(segment.EntityIndex, next);
                    _segmentOfRow.TryAdd(_rows[next], next);
                    next++;
                }
            }
        }
    }

    private void NumberSpans()
    {
        for (var i = 0; i < _timeline.Spans.Count; i++)
        {
            var span = _timeline.Spans[i];
            if (span.Kind == MotionSpanKind.Cut) _cutSpans[span.Stroke][span.Sequence] = i;
        }
    }

    private (int Stroke, int Sequence) PlaceOf(int segment)
    {
        var (low, high) = (0, _firstSegments.Length - 1);
        while (low < high)
        {
            var middle = (low + high + 1) / 2;
            if (_firstSegments[middle][0] <= segment) low = middle;
            else high = middle - 1;
        }

        var place = Array.BinarySearch(_firstSegments[low], segment);
        return (low, place >= 0 ? place : ~place - 1);
    }

    private PlaybackMoment Cutting(in MotionSpan span, double since)
    {
        var sequence = _program.Strokes[span.Stroke].Sequences[span.Sequence];
        var profile = TrapezoidOf(span.Stroke, span.Sequence);
        var path = profile.DistanceAt(since);
        var first = _firstSegments[span.Stroke][span.Sequence];
        var found = Array.BinarySearch(_reached, first, sequence.Segments.Count, path);
        var segment = Math.Min(found >= 0 ? found + 1 : ~found, first + sequence.Segments.Count - 1);
        var from = segment == first ? sequence.Start : _segments[segment - 1].End;
        var done = path - (segment == first ? 0.0 : _reached[segment - 1]);
        var place = SegmentPlace.At(_segments[segment], from, _segments[segment].Length > 0.0 ? done / _segments[segment].Length : 1.0);
        var speed = SegmentPlace.Millimetres(_segments[segment], from, done, profile.SpeedAt(since), _program.Profile.Scale);
        return Moment(span, since, segment, Millimetres(place.X, place.Y), speed);
    }

    private PlaybackMoment Rapid(in MotionSpan span, double since)
    {
        var axes = _timeline.RapidOf(span);
        var (x, y) = (axes[0], axes[1]);
        var place = Millimetres(
            span.From.X + (Math.Sign((long)span.To.X - span.From.X) * x.DistanceAt(since)),
            span.From.Y + (Math.Sign((long)span.To.Y - span.From.Y) * y.DistanceAt(since)));
        var speed = Millimetres(x.SpeedAt(since), y.SpeedAt(since)).DistanceTo(default);
        return Moment(span, since, _firstSegments[span.Stroke][0] + StandsBehind(span), place, speed);
    }

    /// <summary>Place in its stroke of the segment that a standstill or rapid belongs to: the settle at the end of a stroke and the rapid to the finish belong to the segment before, every other one to the segment after.</summary>
    private int StandsBehind(in MotionSpan span)
    {
        var sequence = _program.Strokes[span.Stroke].Sequences[span.Sequence];
        if (span.ToolOn || span.Start < _timeline.Spans[_cutSpans[span.Stroke][span.Sequence]].End - 1e-12) return 0;
        var first = span.Kind == MotionSpanKind.Rapid ? _firstSegments[span.Stroke][span.Sequence] - _firstSegments[span.Stroke][0] : 0;
        return first + sequence.Segments.Count - 1;
    }

    private PlaybackMoment Moment(in MotionSpan span, double since, int segment, Point2D place, double speed) => new(
        span.Start + since, place, speed, span.ToolOn, span.Kind, _program.Strokes[span.Stroke].Index, segment, _segments[segment].EntityIndex, _rows[segment], segment < _lines.Length ? _lines[segment] : 0);

    private Point2D Millimetres(double x, double y) => _program.Profile.Scale.ToMillimetres(x, y);
}

/// <summary>What the planned motion does at one moment.</summary>
/// <param name="Seconds">Since the job began.</param>
/// <param name="Position">Where the tool is, drawing millimetres.</param>
/// <param name="Speed">Along the path, mm/s.</param>
/// <param name="ToolOn">The tool output is on.</param>
/// <param name="Kind">Cutting, between strokes, or standing.</param>
/// <param name="Stroke">Index of the stroke (contour) in the order of cutting.</param>
/// <param name="Segment">Place of the segment in the whole motion program: the one that is cut, or the next one.</param>
/// <param name="Entity">The drawing entity of that segment.</param>
/// <param name="Row">Row of the sequenced entity table of that segment.</param>
/// <param name="Line">Line of the posted program that commands that segment, 1 is first; 0 when no program was posted.</param>
public readonly record struct PlaybackMoment(double Seconds, Point2D Position, double Speed, bool ToolOn, MotionSpanKind Kind, int Stroke, int Segment, int Entity, int Row, int Line);
