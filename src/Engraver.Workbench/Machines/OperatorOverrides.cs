using Engraver.Core.Machines;

namespace Engraver.Workbench.Machines;

/// <summary>The factors of feed and rapid speed that the operator wants, for the job under way and those that follow; and that job's control. Any
/// thread.</summary>
internal sealed class OperatorOverrides
{
    private readonly Lock _guard = new();
    private double _feed = 1.0;
    private double _rapid = 1.0;
    private JobControl? _control;

    /// <summary>Of the job under way; null while none can be held.</summary>
    public JobControl? Control
    {
        get
        {
            lock (_guard) return _control;
        }
    }

    /// <summary>A job begins.</summary>
    public JobControl Begin()
    {
        lock (_guard) return _control = new JobControl { FeedRatio = _feed, RapidRatio = _rapid };
    }

    public void End()
    {
        lock (_guard) _control = null;
    }

    /// <returns>What is in the range of both.</returns>
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
