using Engraver.Core.Machines;

namespace Engraver.Workbench.Tests.Machines.Faults;

/// <summary>Somebody who stops, holds and resumes a run by what it reports, and to whom a fault happens in a part of it.</summary>
internal sealed class FaultOperator(FaultyMachine machine, FaultCase one, CancellationTokenSource stop) : IProgress<JobProgress>
{
    /// <summary>How long a run stays held, seconds.</summary>
    public const double HeldSeconds = 0.5;

    private double _heldSince = double.NaN;
    private bool _asked;

    /// <summary>The hold of the run.</summary>
    public JobControl Control { get; } = new();

    public void Report(JobProgress value)
    {
        if (one.Activity == HostActivity.Stop && value.SegmentsExecuted >= one.At) stop.Cancel();
        if (one.Activity == HostActivity.LeadIn && value.ToolOn) machine.Happen(one.Fault);
        if (one.Activity is HostActivity.Holding or HostActivity.Held or HostActivity.Resuming) Hold(value);
    }

    private void Hold(in JobProgress value)
    {
        if (value.Phase == JobPhase.Holding && one.Activity == HostActivity.Holding) machine.Happen(one.Fault);
        if (value.Phase == JobPhase.Held) Stand(value.Seconds);
        if (_asked || value.SegmentsExecuted < one.At || value.Phase != JobPhase.Running) return;
        _asked = true;
        Control.Hold();
    }

    private void Stand(double seconds)
    {
        if (double.IsNaN(_heldSince))
        {
            _heldSince = seconds;
            if (one.Activity == HostActivity.Held) machine.Happen(one.Fault);
        }

        if (seconds - _heldSince < HeldSeconds || !Control.IsHoldWanted) return;
        if (one.Activity == HostActivity.Resuming) machine.Happen(one.Fault);
        Control.Resume();
    }
}
