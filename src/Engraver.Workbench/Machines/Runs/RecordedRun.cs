using Engraver.Core.Machines;
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

/// <summary>Collects the trace of a running job from its progress.</summary>
/// <remarks>On the job's thread.</remarks>
internal sealed class LiveTrace(PreparedJob job, bool isDryRun)
{
    /// <summary>Maximum number of segments for which deviations are computed during a run.</summary>
    private const int MostSegments = 50_000;

    /// <summary>Controller seconds between two updates of the display.</summary>
    private const double Between = 0.25;

    private readonly RunTraceBuilder _places = RunJudge.PlacesOf(job);
    private double _shown = double.NegativeInfinity;
    private CountsPoint? _error;

    /// <returns>Null if the drawing is too large.</returns>
    public static LiveTrace? Of(PreparedJob job, bool isDryRun) => job.Analysed.Count > MostSegments ? null : new LiveTrace(job, isDryRun);

    /// <summary>Adds a position.</summary>
    /// <returns>The run so far if the display is due; otherwise null.</returns>
    public RecordedRun? Add(JobProgress told)
    {
        _error = told.Error ?? _error;
        _places.Add(RunJudge.Sample(job, told, isDryRun, _error));
        if (told.Seconds - _shown < Between) return null;
        _shown = told.Seconds;
        return new RecordedRun(job, _places.ToTrace("polled"));
    }
}
