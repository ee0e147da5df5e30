using Engraver.Simulator.Values;

namespace Engraver.Simulator.Motion;

/// <summary>CM, DT, CD, WC (galil-dmc.md C.4): increments of several axes over 2^n samples each, at constant speed within a record and without any
/// ramp.</summary>
internal sealed class ContourMode(int capacity)
{
    private readonly Queue<ContourRecord> _waiting = new();
    private Axis[] _axes = [];
    private double[] _start = [];
    private ContourRecord? _record;
    private double _elapsed;

    /// <summary>At least one axis is in contour mode; ended by the end record, ST, AB or a limit.</summary>
    public bool IsOn => _axes.Length > 0;

    /// <summary>A record is being executed or waits.</summary>
    public bool CanProgress => _record is not null || _waiting.Count > 0;

    /// <summary>A contour has started and its end record has not been sent: when its host is late, the axes stop.</summary>
    public bool AwaitsRecords => _record is not null && !_waiting.Any(r => r.IsEnd);

    public ReadOnlySpan<Axis> Axes => _axes;

    /// <summary>Free places for records: <c>_CM</c>. The record being executed does not occupy a place.</summary>
    public int FreeRecords => capacity - _waiting.Count;

    /// <summary>DT: the exponent of the interval, 1 to 8; 0 ends the mode with the next CD.</summary>
    public int TimeExponent { get; set; }

    /// <summary>Samples of TM in a millisecond: the interval counts samples (C, TM).</summary>
    public double SamplesPerStep { get; set; } = 1;

    /// <summary>The records ran out in motion since the last query: TC 42.</summary>
    public bool HadUnderrun { get; private set; }

    /// <summary>WC: there is room for the next record, or no axis is in contour mode.</summary>
    public bool IsReady => !IsOn || _waiting.Count == 0;

    public bool Drives(Axis axis) => Array.IndexOf(_axes, axis) >= 0;

    /// <summary>Sets the axes of contour mode: CM.</summary>
    public void Begin(Axis[] axes)
    {
        _axes = axes;
        _start = new double[axes.Length];
        _record = null;
        foreach (var axis in axes)
        {
            axis.StopCode = StopCode.ContourRunning;
            axis.Smoothing = 1;
        }
    }

    /// <summary>Adds a record: CD.</summary>
    /// <exception cref="CommandRefusedException">TC 32: there is no room for the record [U].</exception>
    public void Store(ContourRecord record)
    {
        if (FreeRecords <= 0) throw new CommandRefusedException(Tc.SegmentBufferFull);
        _waiting.Enqueue(record);
    }

    /// <summary>Stops at once: for the end record, ST, AB, a limit.</summary>
    public void End(int code)
    {
        foreach (var axis in _axes)
        {
            axis.StopCode = code;
            axis.SetPosition(Math.Round(axis.Position, MidpointRounding.AwayFromZero));
            axis.LastStop = axis.Reference;
        }

        _axes = [];
        _record = null;
        _waiting.Clear();
    }

    /// <summary>True once after each time the records have run out.</summary>
    public bool TakeLateness()
    {
        var late = HadUnderrun;
        HadUnderrun = false;
        return late;
    }

    /// <summary>Computes one sample, which can extend over several records.</summary>
    public void Step()
    {
        for (var left = SamplesPerStep; left > 0 && (_record is not null || TryTake());)
        {
            var used = Math.Min(left, _record!.Samples - _elapsed);
            _elapsed += used;
            left -= used;
            MoveAxes(_record);
            if (_elapsed >= _record.Samples) FinishRecord();
        }
    }

    private bool TryTake()
    {
        if (!_waiting.TryDequeue(out var next)) return false;
        if (next.IsEnd)
        {
            End(StopCode.ContourDone);
            return false;
        }

        for (var i = 0; i < _axes.Length; i++) _start[i] = _axes[i].Position;
        _record = next;
        _elapsed = 0;
        return true;
    }

    private void FinishRecord()
    {
        _record = null;
        HadUnderrun |= _waiting.Count == 0;
        if (_waiting.TryPeek(out var next) && next.IsEnd) TryTake();
    }

    private void MoveAxes(ContourRecord record)
    {
        for (var i = 0; i < _axes.Length; i++) _axes[i].SetPosition(_start[i] + (record.Increments[i] * _elapsed / record.Samples));
    }
}
