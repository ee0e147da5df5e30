using System.Runtime.InteropServices;

namespace Engraver.Core.Machines;

/// <summary>The segments and sequences of a motion program as columns: 40 bytes for a line, 24 more for an arc, 16 for a sequence, 56 for a stroke. Objects are
/// created only while they are read.</summary>
/// <remarks>One writer appends stroke by stroke; the data of a stroke does not change afterwards and may be read from all threads.</remarks>
/// <param name="segments">Approximate number of segments: memory for this number is allocated at once.</param>
public sealed class VectorColumns(int segments)
{
    private const int NoArc = -1;
    private const int HeightChanges = -1;
    private readonly List<SegmentCells> _segments = new(segments);
    private readonly List<ArcCells> _arcs = [];
    private readonly List<SequenceCells> _sequences = [];
    private readonly List<StrokeCells> _strokes = [];

    /// <summary>Shares of the segments that have several entities.</summary>
    private readonly Dictionary<int, IReadOnlyList<EntityShare>> _shares = [];

    /// <summary>Number of segments so far.</summary>
    public int SegmentCount => _segments.Count;

    /// <summary>Appends a sequence; it begins where the last one of its stroke ends.</summary>
    /// <param name="speed">As <see cref="VectorSequence.Speed"/>.</param>
    /// <param name="acceleration">As <see cref="VectorSequence.Acceleration"/>.</param>
    /// <param name="cut">At least one.</param>
    /// <param name="changesHeight">As <see cref="VectorSequence.ChangesHeight"/>.</param>
    /// <param name="feed">As <see cref="VectorSequence.Feed"/>; not kept where heights change.</param>
    public void Append(int speed, int acceleration, IReadOnlyList<VectorSegment> cut, bool changesHeight, int? feed = null)
    {
        ArgumentNullException.ThrowIfNull(cut);
        BeginSequence();
        for (var i = 0; i < cut.Count; i++) Add(cut[i]);
        EndSequence(speed, acceleration, changesHeight, feed, isUniform: false);
    }

    /// <summary>Begins a sequence of the segments that are added next; it begins where the last one of its stroke ends.</summary>
    public void BeginSequence() => _sequences.Add(new SequenceCells { First = _segments.Count });

    /// <summary>Ends the sequence that was started last.</summary>
    /// <param name="speed">As <see cref="VectorSequence.Speed"/>.</param>
    /// <param name="acceleration">As <see cref="VectorSequence.Acceleration"/>.</param>
    /// <param name="changesHeight">As <see cref="VectorSequence.ChangesHeight"/>.</param>
    /// <param name="feed">As <see cref="VectorSequence.Feed"/>; not kept where heights change.</param>
    /// <param name="isUniform">Every segment has this speed, and states none of its own.</param>
    public void EndSequence(int speed, int acceleration, bool changesHeight, int? feed, bool isUniform)
    {
        var first = _sequences[^1].First;
        _sequences[^1] = new SequenceCells { First = first, Speed = speed, Acceleration = acceleration, Feed = changesHeight ? HeightChanges : feed ?? 0 };
        if (!isUniform) return;
        foreach (ref var segment in CollectionsMarshal.AsSpan(_segments)[first..]) segment.Speed = 0;
    }

    /// <summary>Appends a stroke of the sequences that were appended since the last one.</summary>
    /// <param name="index">Index of the stroke of the toolpath.</param>
    /// <param name="start">Where it begins.</param>
    /// <param name="terms">As <see cref="MotionStroke.Terms"/>.</param>
    /// <returns>False when there are no such sequences: nothing is appended.</returns>
    public bool EndStroke(int index, CountsPoint start, StrokeTerms? terms = null)
    {
        var first = _strokes.Count == 0 ? 0 : _strokes[^1].EndOfSequences;
        if (first == _sequences.Count) return false;
        _strokes.Add(new StrokeCells { Index = index, Start = start, FirstSequence = first, EndOfSequences = _sequences.Count, EndOfSegments = _segments.Count, Terms = terms });
        return true;
    }

    /// <summary>The strokes so far, each created when it is requested.</summary>
    public IReadOnlyList<MotionStroke> Strokes() => new ComputedList<MotionStroke>(_strokes.Count, Stroke);

    private MotionStroke Stroke(int index)
    {
        var cells = _strokes[index];
        return new MotionStroke(cells.Index, cells.Start, new StrokeSequences(this, cells.Start, cells.FirstSequence, cells.EndOfSequences - cells.FirstSequence, cells.EndOfSegments)) { Terms = cells.Terms };
    }

    internal VectorSegment Segment(int index)
    {
        var cells = _segments[index];
        var (kind, arc) = cells.Arc == NoArc ? (VectorSegmentKind.Line, default) : (VectorSegmentKind.Arc, _arcs[cells.Arc]);
        return new VectorSegment(kind, cells.End, arc.Radius, arc.ThetaDegrees, arc.DeltaDegrees, cells.Entity, cells.Length)
        {
            Speed = cells.Speed, Move = cells.Move, Moves = cells.Moves, Shares = cells.Moves > 1 ? _shares.GetValueOrDefault(index) : null,
        };
    }

    internal int FirstSegmentOf(int sequence) => _sequences[sequence].First;

    internal VectorSequence Sequence(int sequence, CountsPoint start, int end) =>
        new(start, _sequences[sequence].Speed, new SequenceSegments(this, _sequences[sequence].First, end)) 
        {
            ChangesHeight = _sequences[sequence].Feed == HeightChanges,
            Acceleration = _sequences[sequence].Acceleration,
            Feed = _sequences[sequence].Feed > 0 ? _sequences[sequence].Feed : null,
        };

    internal int SpeedOf(int segment) => _segments[segment].Speed;

    internal double LengthOf(int segment) => _segments[segment].Length;

    internal CountsPoint EndOf(int segment) => _segments[segment].End;

    /// <summary>Adds a segment to the sequence that was started last.</summary>
    public void Add(in VectorSegment segment)
    {
        var arc = segment.Kind == VectorSegmentKind.Line ? NoArc : _arcs.Count;
        if (arc != NoArc) _arcs.Add(new ArcCells { Radius = segment.Radius, ThetaDegrees = segment.ThetaDegrees, DeltaDegrees = segment.DeltaDegrees });
        if (segment.Shares is { } shares) _shares[_segments.Count] = shares;
        _segments.Add(new SegmentCells { End = segment.End, Entity = segment.EntityIndex, Length = segment.Length, Arc = arc, Speed = segment.Speed, Move = segment.Move, Moves = segment.Moves });
    }

    private struct SegmentCells
    {
        public double Length;
        public CountsPoint End;
        public int Entity;
        public int Arc;
        public int Speed;
        public int Move;
        public int Moves;
    }

    private struct ArcCells
    {
        public double ThetaDegrees;
        public double DeltaDegrees;
        public int Radius;
    }

    private struct StrokeCells
    {
        public StrokeTerms? Terms;
        public CountsPoint Start;
        public int Index;
        public int FirstSequence;
        public int EndOfSequences;
        public int EndOfSegments;
    }

    private struct SequenceCells
    {
        public int First;
        public int Speed;
        public int Acceleration;

        /// <summary>0 where it is not known, <see cref="HeightChanges"/> where heights change.</summary>
        public int Feed;
    }
}

/// <summary>The sequences of one stroke, read from the columns of its program.</summary>
internal sealed class StrokeSequences(VectorColumns columns, CountsPoint start, int first, int count, int endOfSegments) : IndexedList<VectorSequence>
{
    public override int Count => count;

    public int SegmentCount => count == 0 ? 0 : endOfSegments - columns.FirstSegmentOf(first);

    protected override VectorSequence ItemAt(int index)
    {
        var sequence = first + index;
        var end = index + 1 < count ? columns.FirstSegmentOf(sequence + 1) : endOfSegments;
        return columns.Sequence(sequence, index == 0 ? start : columns.EndOf(columns.FirstSegmentOf(sequence) - 1), end);
    }
}

/// <summary>The segments of one sequence, read from the columns of its program.</summary>
internal sealed class SequenceSegments(VectorColumns columns, int first, int end) : IndexedList<VectorSegment>
{
    public override int Count => end - first;

    /// <summary>Path length, counts.</summary>
    public double Length
    {
        get
        {
            var length = 0.0;
            for (var i = first; i < end; i++) length += columns.LengthOf(i);
            return length;
        }
    }

    /// <summary>A segment has a speed of its own.</summary>
    public bool HaveOwnSpeeds
    {
        get
        {
            for (var i = first; i < end; i++)
            {
                if (columns.SpeedOf(i) != 0) return true;
            }

            return false;
        }
    }

    protected override VectorSegment ItemAt(int index) => columns.Segment(first + index);
}
