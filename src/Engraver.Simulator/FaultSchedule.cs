namespace Engraver.Simulator;

/// <summary>Triggers the scheduled faults of a plan. All members are called under the controller's lock.</summary>
internal sealed class FaultSchedule
{
    private const double SamplesPerSecond = 1000.0;

    private readonly Machine _machine;
    private readonly List<ScheduledFault> _planned;
    private readonly List<(long Due, Action End)> _endings = [];
    private readonly Random _garbage = new(1);
    private int _late;
    private int _lostCommands;
    private int _lostReplies;
    private int _garbageBytes;
    private TimeSpan _delay;

    public FaultSchedule(Machine machine, FaultPlan? plan)
    {
        _machine = machine;
        _planned = [.. plan?.Faults ?? []];
        UpdateNext();
    }

    /// <summary>The first sample in which a fault starts or ends at a controller time; <see cref="long.MaxValue"/> when there is none.</summary>
    public long NextDue { get; private set; }

    /// <summary>A fault waits for a segment: no sample may be skipped.</summary>
    public bool AwaitsSegment { get; private set; }

    /// <summary>A command or its answer was lost: its host waits for an answer that is never sent.</summary>
    public bool IsReplyPending { get; private set; }

    /// <summary>Bytes that have arrived so far, over all links.</summary>
    public long Bytes { get; private set; }

    /// <summary>Adds a fault; a fault whose trigger has already passed occurs at once.</summary>
    public void Add(ScheduledFault fault)
    {
        _planned.Add(fault);
        Apply();
    }

    /// <summary>Called after every sample, and after every jump over several samples.</summary>
    public void Step()
    {
        if (NextDue > _machine.Sample && !AwaitsSegment) return;
        for (var i = _endings.Count - 1; i >= 0; i--)
        {
            if (_endings[i].Due > _machine.Sample) continue;
            _endings[i].End();
            _endings.RemoveAt(i);
        }

        Apply();
    }

    /// <summary>Called when a byte has arrived.</summary>
    public void ByteReceived()
    {
        Bytes++;
        if (_planned.Count > 0) Apply();
    }

    /// <summary>True when the command that has just arrived is lost.</summary>
    public bool LosesCommand()
    {
        IsReplyPending = _lostCommands > 0;
        if (IsReplyPending) _lostCommands--;
        return IsReplyPending;
    }

    /// <summary>True when the answer that is about to be sent is lost.</summary>
    public bool LosesReply()
    {
        IsReplyPending = _lostReplies > 0;
        if (IsReplyPending) _lostReplies--;
        return IsReplyPending;
    }

    /// <summary>Delay of the answer that is about to be sent.</summary>
    public TimeSpan TakeDelay()
    {
        if (_late == 0) return TimeSpan.Zero;
        _late--;
        return _delay;
    }

    /// <summary>Garbage bytes to send before the answer that is about to be sent.</summary>
    public byte[] TakeGarbage()
    {
        var bytes = new byte[_garbageBytes];
        _garbage.NextBytes(bytes);
        _garbageBytes = 0;
        return bytes;
    }

    private void Apply()
    {
        for (var i = 0; i < _planned.Count; i++)
        {
            var fault = _planned[i];
            if (!IsTime(fault)) continue;
            _planned.RemoveAt(i--);
            Begin(fault);
        }

        UpdateNext();
    }

    private bool IsTime(ScheduledFault fault) =>
        fault.AtSeconds is { } seconds ? _machine.Sample >= SampleOf(seconds)
        : fault.AtSegment is { } segment ? _machine.Motion.SegmentsExecuted >= segment
        : Bytes >= fault.AtByte;

    private void Begin(ScheduledFault fault)
    {
        switch (fault.Kind)
        {
            case FaultKind.Delay: (_late, _delay) = (fault.Count, TimeSpan.FromSeconds(fault.Seconds)); break;
            case FaultKind.DropCommand: _lostCommands += fault.Count; break;
            case FaultKind.DropReply: _lostReplies += fault.Count; break;
            case FaultKind.Garbage: _garbageBytes += fault.Count; break;
            case FaultKind.Reset: _machine.CutLinks(); break;
            case FaultKind.LimitSwitch: Switch(fault, on => _machine.Motion.Axes[fault.AxisIndex].Inputs.Ground(fault.Forward, on)); break;
            case FaultKind.AbortInput: Switch(fault, _machine.SetAbortInput); break;
            case FaultKind.MotorOff: _machine.Motion.Halt(_machine.Motion.Axes[fault.AxisIndex], Motion.StopCode.OffOnError, motorsOff: true); break;
            case FaultKind.Jam: Switch(fault, on => _machine.Motion.Axes[fault.AxisIndex].Motor.IsHeld = on); break;
            case FaultKind.PowerCycle: _machine.PowerCycle(); break;
            default: throw new InvalidOperationException($"There is no fault of kind {fault.Kind}.");
        }
    }

    private void Switch(ScheduledFault fault, Action<bool> set)
    {
        set(true);
        if (fault.ForSeconds is { } seconds) _endings.Add((_machine.Sample + Math.Max(1, SampleOf(seconds)), () => set(false)));
    }

    private void UpdateNext()
    {
        NextDue = long.MaxValue;
        foreach (var fault in _planned) NextDue = Math.Min(NextDue, fault.AtSeconds is { } seconds ? SampleOf(seconds) : long.MaxValue);
        foreach (var (due, _) in _endings) NextDue = Math.Min(NextDue, due);
        AwaitsSegment = _planned.Exists(fault => fault.AtSegment is not null);
    }

    private static long SampleOf(double seconds) => (long)Math.Round(seconds * SamplesPerSecond);
}
