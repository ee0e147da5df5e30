using Engraver.Workbench.Documents;
using Engraver.Workbench.Machines.Runs;

namespace Engraver.Workbench.Plots;

/// <summary>A limit of the machine profile or of the job, drawn as a line across a plot.</summary>
/// <param name="Quantity">The limited quantity.</param>
/// <param name="Value">In the unit of the quantity.</param>
public readonly record struct PlotLimit(PlotQuantity Quantity, double Value)
{
    private const double Whole = 100.0;

    /// <summary>The limits of a job: rapid speed and acceleration of the machine, the following error that the profile allows at the fastest cut, the maximum
    /// deviation; for the override and the load of the link 100 %.</summary>
    public static IReadOnlyList<PlotLimit> Of(PreparedJob job)
    {
        ArgumentNullException.ThrowIfNull(job);
        var machine = job.Settings.CuttingMachine;
        var (x, y) = (machine.Scale.X.LengthOf(machine.AccelerationCounts), machine.Scale.Y.LengthOf(machine.AccelerationCounts));
        List<PlotLimit> limits =
        [
            new(PlotQuantity.Speed, machine.RapidMmPerMinute),
            new(PlotQuantity.AccelerationX, x),
            new(PlotQuantity.AccelerationX, -x),
            new(PlotQuantity.AccelerationY, y),
            new(PlotQuantity.AccelerationY, -y),
            new(PlotQuantity.Deviation, RunJudge.Tolerances(job).Deviation),
            new(PlotQuantity.FeedOverride, Whole),
            new(PlotQuantity.LinkLoad, Whole),
        ];
        if (job.Motion.Program is { } program) limits.Add(new(PlotQuantity.FollowingError, RunJudge.AllowedFollowing(program)));
        return limits;
    }
}
