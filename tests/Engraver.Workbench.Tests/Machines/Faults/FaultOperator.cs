using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;

namespace Engraver.Workbench.Tests.Machines.Faults;

/// <summary>An operator who stops, holds, moves and resumes a run according to its progress, with a fault in one part of it.</summary>
internal sealed class FaultOperator(FaultyMachine machine, FaultCase one, CancellationTokenSource stop) : IProgress<JobProgress>
{
    /// <summary>Duration of a feed hold, seconds.</summary>
    public const double HeldSeconds = 0.5;

    /// <summary>A jog key during a feed hold is released after this many counts, or after a second.</summary>
    private const int FarEnough = 3_000;
    private const double LongEnough = 1.0;

    private double _heldSince = double.NaN;
    private bool _asked;
    private CountsPoint _heldAt;
    private JogControl? _key;
    private Task<JobResult>? _moved;

    /// <summary>The feed hold of the run.</summary>
    public JobControl Control { get; } = new();

    public void Report(JobProgress value)
    {
        if (one.Activity == HostActivity.Stop && value.SegmentsExecuted >= one.At) stop.Cancel();
        if (one.Activity == HostActivity.LeadIn && value.ToolOn) machine.Inject(one.Fault);
        if (one.IsHeld) Hold(value);
    }

    private void Hold(in JobProgress value)
    {
        if (value.Phase == JobPhase.Holding && one.Activity == HostActivity.Holding) machine.Inject(one.Fault);
        if (value.Phase == JobPhase.Held) NoteStandstill(value.Place, value.Seconds);
        if (_asked || value.SegmentsExecuted < one.At || value.Phase != JobPhase.Running) return;
        _asked = true;
        Control.Hold();
    }

    private void NoteStandstill(CountsPoint at, double seconds)
    {
        if (double.IsNaN(_heldSince))
        {
            _heldSince = seconds;
            if (one.Activity == HostActivity.Held) machine.Inject(one.Fault);
        }

        if (seconds - _heldSince < HeldSeconds || !Control.IsHoldWanted || (one.Activity is HostActivity.Away or HostActivity.ComingBack && !IsMoved(at, seconds))) return;
        if (one.Activity is HostActivity.Resuming or HostActivity.ComingBack) machine.Inject(one.Fault);
        if (one.IsStoppedAway) stop.Cancel();
        else Control.Resume();
    }

    /// <summary>Moves manually once: by a step or a continuous jog.</summary>
    /// <returns>Whether it was done, with any result.</returns>
    private bool IsMoved(CountsPoint at, double seconds)
    {
        if (_moved is null)
        {
            _heldAt = at;
            _key = one.Seed % 2 == 0 ? new JogControl(new JogVelocity(-600.0, 300.0)) : null;
            if (one.Activity == HostActivity.Away) machine.Inject(one.Fault);
            _moved = Control.MoveAsync(_key is { } key ? MoveInHold.While(key) : MoveInHold.By(one.Step ?? new CountsPoint(-4_000, 2_500, machine.HasHeight ? 800 : 0)));
        }

        if (!_moved.IsCompleted && (Math.Abs(at.X - _heldAt.X) >= FarEnough || seconds - _heldSince > HeldSeconds + LongEnough)) _key?.Release();
        return _moved.IsCompleted;
    }
}
