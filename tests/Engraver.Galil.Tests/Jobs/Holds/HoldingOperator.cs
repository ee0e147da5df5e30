using Engraver.Core.Machines;

namespace Engraver.Galil.Tests.Jobs.Holds;

/// <summary>An operator who holds a job and resumes it, triggered by its reports.</summary>
/// <param name="at">When to hold.</param>
/// <param name="heldSeconds">Duration of the hold, controller time.</param>
internal sealed class HoldingOperator(SimulatedBench bench, Func<JobProgress, bool> at, double heldSeconds) : IProgress<JobProgress>
{
    private double _heldSince = double.NaN;
    private double _resumedAt = double.NegativeInfinity;

    public JobControl Control { get; } = new();

    /// <summary>Number of holds.</summary>
    public int Repeats { get; init; } = 1;

    /// <summary>Controller seconds from a resume to the next hold.</summary>
    public double Between { get; init; }

    /// <summary>Called when the job is held; null for resuming.</summary>
    public Action? WhenHeld { get; init; }

    public List<JobPhase> Phases { get; } = [];

    /// <summary>Position of the last hold, job frame.</summary>
    public CountsPoint HeldAt { get; private set; }

    /// <summary>Controller samples from the first report of the hold to the resume.</summary>
    public List<(long From, long To)> Held { get; } = [];

    private int _asked;
    private long _heldSample;

    public void Report(JobProgress value)
    {
        if (Phases.LastOrDefault() != value.Phase) Phases.Add(value.Phase);
        if (value.Phase == JobPhase.Held) Stand(value);
        else if (value.Phase == JobPhase.Running && !Control.IsHoldWanted && _asked < Repeats && value.Seconds - _resumedAt >= Between && at(value))
        {
            _asked++;
            Control.Hold();
        }
    }

    private void Stand(JobProgress value)
    {
        if (double.IsNaN(_heldSince)) (_heldSince, _heldSample, HeldAt) = (value.Seconds, bench.Controller.Status.Sample, new CountsPoint(value.X, value.Y));
        if (value.Seconds - _heldSince < heldSeconds || !Control.IsHoldWanted) return;
        if (WhenHeld is { } act)
        {
            act();
            return;
        }

        Held.Add((_heldSample, bench.Controller.Status.Sample));
        (_heldSince, _resumedAt) = (double.NaN, value.Seconds);
        _asked = Math.Max(_asked, 1);
        Control.Resume();
    }
}
