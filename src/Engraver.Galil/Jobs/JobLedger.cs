using Engraver.Core.Diagnostics;
using Engraver.Core.Machines;
using Engraver.Core.Motion;

namespace Engraver.Galil.Jobs;

/// <summary>Counts what was sent and what the controller confirmed; the one place where a job is counted.</summary>
/// <param name="program">The whole program: segments and strokes are counted in it, also where only its rest is cut.</param>
/// <param name="rest">What is cut; null for all of it.</param>
/// <param name="from">What is before it was cut by an earlier job.</param>
/// <param name="polled">Called with every polled position that differs from the one before; null for no call.</param>
internal sealed class JobLedger(MotionProgram program, RemainingProgram? rest = null, JobPosition from = default, Action<TracePoint>? polled = null)
{
    /// <summary>A position further from the path than this is not on it, counts.</summary>
    private const double OnPath = 2.5;

    private readonly List<TracePoint> _trace = [];
    private readonly List<int> _entities = [];
    private readonly HashSet<int> _seen = [];
    private readonly List<(int Stroke, VectorSegment Segment)> _uncut = [];
    private readonly int[] _executed = new int[program.Strokes.Count];
    private readonly double[] _lengths = new double[program.Strokes.Count];
    private RemainingProgram _rest = rest ?? RemainingProgram.Whole(program);
    private double _cutOfFirst;
    private JobPosition _cut = from;
    private (int Segments, CountsPoint At)? _cutting;
    private bool _isToolMissing;

    /// <summary>Segments that an earlier job had cut.</summary>
    private readonly int _first = rest?.SegmentsBefore ?? 0;

    public int SegmentCount { get; } = program.SegmentCount;

    /// <summary>Index of the present stroke in the whole program.</summary>
    public int Stroke { get; private set; }

    /// <summary>Index of the present sequence in its stroke.</summary>
    public int Sequence { get; private set; }

    /// <summary>Segments of the whole program before those that this job cuts.</summary>
    public int SegmentsBefore => _rest.SegmentsBefore;

    /// <summary>The machine is being stopped with the tool off: segments that are counted from now on were passed and not cut.</summary>
    public bool IsStopping { get; set; }

    /// <summary>Everything before it was certainly cut.</summary>
    /// <remarks>Polls do not change it while <see cref="IsAway"/>.</remarks>
    public JobPosition Place => _cutting is { } seen ? JobPosition.Max(_cut, ProgramPositionFinder.Find(program, seen.Segments, seen.At, OnPath)) : _cut;

    /// <summary>The job is held and the operator may move the machine: what it passes is not cut.</summary>
    public bool IsAway { get; private set; }

    public int Sent { get; set; }

    public int Executed { get; private set; }

    /// <summary>The last poll saw the tool off although it should have been on. What is confirmed meanwhile counts as cut only if the next poll sees it
    /// on.</summary>
    public bool IsToolMissing
    {
        get => _isToolMissing;
        set
        {
            _isToolMissing = value;
            if (value) return;
            if (_uncut.Count == 0) return;
            foreach (var (stroke, segment) in _uncut) CountCut(stroke, segment);
            _uncut.Clear();
            _cut = JobPosition.Max(_cut, new JobPosition(Executed, 0.0));
        }
    }

    /// <summary>Segments confirmed while the tool was seen off.</summary>
    public int Uncut => _uncut.Count;

    public int Underruns { get; set; }

    public int Rejected { get; set; }

    /// <summary>Findings about how the job was run: strokes that were divided because of the memory.</summary>
    public List<Diagnostic> Diagnostics { get; } = [];

    /// <summary>What went wrong without ending the job.</summary>
    public List<Diagnostic> Warnings { get; } = [];

    /// <summary>The last position with the tool on and the last with the tool off, in the order in which they were polled.</summary>
    public IReadOnlyList<TracePoint> Trace => _trace;

    public IReadOnlyList<int> Entities => _entities;

    public IReadOnlyList<int> ExecutedByStroke => _executed;

    public IReadOnlyList<double> LengthByStroke => _lengths;

    public void Confirm(in VectorSegment segment)
    {
        Executed++;
        _executed[Stroke]++;
        if (IsToolMissing) _uncut.Add((Stroke, segment));
        else CountCut(Stroke, segment);
        if (!IsToolMissing && !IsStopping) _cut = JobPosition.Max(_cut, new JobPosition(Executed, 0.0));
    }

    /// <summary>The machine continues with a stroke and a sequence of what this job cuts.</summary>
    public void Enter(int stroke, int sequence) => (Stroke, Sequence) = (stroke + _rest.StrokesBefore, stroke == 0 ? sequence + _rest.SequencesBefore : sequence);

    /// <summary>A poll saw the tool on here.</summary>
    /// <param name="segments">Segments that were done, in the whole program.</param>
    /// <param name="at">Job frame.</param>
    public void SeeCutting(int segments, CountsPoint at)
    {
        if (!IsAway) _cutting = (segments, at);
    }

    /// <summary>The job is held, and what was in progress is given up.</summary>
    /// <param name="segments">Segments that are done, in the whole program.</param>
    /// <param name="at">Where the machine is in the next one, job frame; null where it was not started since something was last given up, as on the way
    /// back.</param>
    public void GiveUp(int segments, CountsPoint? at)
    {
        PlaceGivenUp = at is { } here ? ProgramPositionFinder.Find(program, segments, here, OnPath) : JobPosition.Max(PlaceGivenUp, new JobPosition(segments, 0.0));
        _cut = JobPosition.Max(Place, PlaceGivenUp);
        (_cutting, IsAway) = (null, true);
    }

    /// <summary>Where the machine was when the job gave up what was in progress; in a lead-in this is before <see cref="Place"/>.</summary>
    public JobPosition PlaceGivenUp { get; private set; }

    /// <summary>The job continues with what is left after <see cref="PlaceGivenUp"/>.</summary>
    /// <param name="left">Begins at that place or, where the segment that contains it has no rest to cut, after it.</param>
    public void Continue(RemainingProgram left)
    {
        _cutOfFirst = 0.0;
        while (Executed < left.SegmentsBefore && program.SegmentAfter(Executed) is var (_, segment, stroke))
        {
            Stroke = stroke;
            Confirm(segment);
        }

        (_rest, _cutOfFirst, IsAway) = (left, left.CutLengthOfFirst, false);
        Sent = Math.Min(Sent, left.SegmentsBefore - _first);
        Enter(0, 0);
    }

    /// <summary>Counts what an earlier job has cut.</summary>
    public void Begin()
    {
        var left = Executed = _rest.SegmentsBefore;
        for (var stroke = 0; stroke < program.Strokes.Count && left > 0; stroke++)
        {
            foreach (var segment in program.Strokes[stroke].Sequences.SelectMany(sequence => sequence.Segments).Take(left))
            {
                _executed[stroke]++;
                left--;
                CountCut(stroke, segment);
            }
        }

        _cutOfFirst = _rest.CutLengthOfFirst;
        Enter(0, 0);
    }

    private void CountCut(int stroke, in VectorSegment segment)
    {
        _lengths[stroke] += segment.Length;
        if (Executed > _rest.SegmentsBefore) (_lengths[stroke], _cutOfFirst) = (_lengths[stroke] + _cutOfFirst, 0.0);
        if (_seen.Add(segment.EntityIndex)) _entities.Add(segment.EntityIndex);
        for (var i = 1; i < segment.Shares?.Count; i++)
        {
            if (_seen.Add(segment.Shares[i].EntityIndex)) _entities.Add(segment.Shares[i].EntityIndex);
        }
    }

    /// <summary>Passes a polled position on if it differs from the last. Memory does not grow with the time of the job.</summary>
    public void Trail(TracePoint point)
    {
        if (_trace.Count > 0 && _trace[^1] with { Seconds = point.Seconds, Error = point.Error } == point) return;
        _trace.RemoveAll(passed => passed.ToolOn == point.ToolOn);
        _trace.Add(point);
        polled?.Invoke(point);
    }
}
