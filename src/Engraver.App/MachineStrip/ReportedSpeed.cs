using Engraver.Workbench.Machines;

namespace Engraver.App.MachineStrip;

/// <summary>The speed of the tool while a job runs: the distance between two reported positions divided by the time on the controller's clock.</summary>
/// <remarks>A chord is shorter than its arc: at a tenth of a second and a radius of 1 mm by 4 % at 600 mm/min.</remarks>
internal sealed class ReportedSpeed
{
    /// <summary>Minimum controller time between two positions, seconds; over a shorter time the speed is too inaccurate.</summary>
    private const double MinSeconds = 0.1;

    private EngravedProgress? _last;

    /// <summary>mm/s; null while no job runs, and before its second position.</summary>
    public double? Current { get; private set; }

    /// <param name="progress">Last progress of the running job; null when none runs.</param>
    public void Update(EngravedProgress? progress)
    {
        if (progress is null || _last is null || progress.Seconds < _last.Seconds)
        {
            (_last, Current) = (progress, null);
            return;
        }

        var since = progress.Seconds - _last.Seconds;
        if (since < MinSeconds) return;
        (Current, _last) = (progress.Position.DistanceTo(_last.Position) / since, progress);
    }
}
