using Engraver.Core.Diagnostics;
using Engraver.Core.Machines;

namespace Engraver.Galil.Jobs;

/// <summary>Counts what was sent and what the controller confirmed; the one place where a job is counted.</summary>
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

    /// <summary>Index of the present stroke in the motion program.</summary>
    public int Stroke { get; set; }

    /// <summary>Index of the present sequence in its stroke.</summary>
    public int Sequence { get; set; }

    public int Sent { get; set; }

    public int Executed { get; private set; }

    /// <summary>The last poll saw the tool off although it should have been on. What is confirmed meanwhile counts as cut only if the next poll sees it on.</summary>
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

    /// <summary>Findings about how the job was run: strokes that were divided because of the memory.</summary>
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

    /// <summary>Keeps a polled position if it differs from the last; where no trace is kept, only the last with the tool on and the last with the tool off.</summary>
    public void Trail(TracePoint point)
    {
        if (_trace.Count > 0 && _trace[^1] with { Seconds = point.Seconds } == point) return;
        if (!keepsTrace) _trace.RemoveAll(passed => passed.ToolOn == point.ToolOn);
        _trace.Add(point);
    }
}
