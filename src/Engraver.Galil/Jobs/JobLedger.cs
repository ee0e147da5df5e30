using Engraver.Core.Diagnostics;
using Engraver.Core.Machines;

namespace Engraver.Galil.Jobs;

/// <summary>What was sent and what the controller confirmed. The one place where a job is counted.</summary>
internal sealed class JobLedger(MotionProgram program, bool keepsTrace = true)
{
    private readonly List<TracePoint> _trace = [];
    private readonly List<int> _entities = [];
    private readonly HashSet<int> _seen = [];
    private readonly List<(int Stroke, VectorSegment Segment)> _uncut = [];
    private readonly int[] _executed = new int[program.Strokes.Count];
    private readonly double[] _lengths = new double[program.Strokes.Count];
    private bool _isToolMissing;

    public int SegmentCount { get; } = program.SegmentCount;

    /// <summary>Place of the stroke under way in the motion program.</summary>
    public int Stroke { get; set; }

    /// <summary>Place of the sequence under way in its stroke.</summary>
    public int Sequence { get; set; }

    public int Sent { get; set; }

    public int Executed { get; private set; }

    /// <summary>The last poll saw the tool off though it should have been on: what is confirmed now counts as cut only when the next one takes that back.</summary>
    public bool IsToolMissing
    {
        get => _isToolMissing;
        set
        {
            _isToolMissing = value;
            if (value) return;
            foreach (var (stroke, segment) in _uncut) CountCut(stroke, segment);
            _uncut.Clear();
        }
    }

    /// <summary>Segments confirmed while the tool was seen off.</summary>
    public int Uncut => _uncut.Count;

    public int Underruns { get; set; }

    public int Rejected { get; set; }

    /// <summary>What had to be done to the job to run it: strokes that the memory cut.</summary>
    public List<Diagnostic> Diagnostics { get; } = [];

    /// <summary>What went wrong without ending the job.</summary>
    public List<Diagnostic> Warnings { get; } = [];

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
    }

    private void CountCut(int stroke, in VectorSegment segment)
    {
        _lengths[stroke] += segment.Length;
        if (_seen.Add(segment.EntityIndex)) _entities.Add(segment.EntityIndex);
    }

    /// <summary>Keeps a polled position unless nothing has changed since the last; where no trace is kept, the last one with the tool on and the last with the tool off.</summary>
    public void Trail(TracePoint point)
    {
        if (_trace.Count > 0 && _trace[^1] with { Seconds = point.Seconds } == point) return;
        if (!keepsTrace) _trace.RemoveAll(passed => passed.ToolOn == point.ToolOn);
        _trace.Add(point);
    }
}
