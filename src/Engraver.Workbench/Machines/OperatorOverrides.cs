using Engraver.Core.Machines;

namespace Engraver.Workbench.Machines;

/// <summary>The feed and rapid overrides for the running job and the following ones, and the control of the running job. Any thread.</summary>
internal sealed class OperatorOverrides
{
    private readonly Lock _guard = new();
    private double _feed = 1.0;
    private double _rapid = 1.0;
    private JobControl? _control;

    /// <summary>Control of the running job; null if there is none.</summary>
    public JobControl? Control
    {
        get
        {
            lock (_guard) return _control;
        }
    }

    /// <summary>Starts a job.</summary>
    public JobControl Begin()
    {
        lock (_guard) return _control = new JobControl { FeedRatio = _feed, RapidRatio = _rapid };
    }

    public void End()
    {
        lock (_guard) _control = null;
    }

    /// <returns>The overrides limited to their ranges.</returns>
    public (double Feed, double Rapid) Set(double? feed, double? rapid)
    {
        lock (_guard)
        {
            var control = _control ?? new JobControl { FeedRatio = _feed, RapidRatio = _rapid };
            if (feed is { } first) control.FeedRatio = first;
            if (rapid is { } second) control.RapidRatio = second;
            return (_feed, _rapid) = (control.FeedRatio, control.RapidRatio);
        }
    }
}
