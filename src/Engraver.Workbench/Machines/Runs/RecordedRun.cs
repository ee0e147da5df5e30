using Engraver.Core.Plots;
using Engraver.Core.Verification;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Machines.Runs;

/// <summary>The trace of a run: the last run or a saved one.</summary>
public sealed record RecordedRun(PreparedJob Job, RunTrace Trace)
{
    /// <summary>Maximum allowed deviation, mm.</summary>
    public double ToleranceMm => RunJudge.Tolerances(Job).Deviation;

    /// <summary>Colour value for each position: the deviation as a fraction of the tolerance, other quantities as a fraction of their maximum in the run; 0 if
    /// unknown.</summary>
    public double[] Colours(RunMeasure measure)
    {
        var values = RunPlot.Values(Trace, measure);
        var whole = measure == RunMeasure.Deviation ? ToleranceMm : Trace.Places.Select((place, i) => place.ToolOn ? values[i] : 0.0).DefaultIfEmpty().Max();
        return whole > 0.0 ? [.. values.Select(value => value / whole)] : new double[values.Length];
    }
}
