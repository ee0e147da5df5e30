using Engraver.Core.Machines;
using Engraver.Core.Plots;
using Engraver.Core.Verification;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Machines.Runs;

/// <summary>Where the machine was in a run of a job: the last one, or one that was kept.</summary>
public sealed record RecordedRun(PreparedJob Job, RunTrace Trace)
{
    /// <summary>The distance from the drawing that a faithful run may have, mm.</summary>
    public double ToleranceMm => RunJudge.Tolerances(Job).Deviation;

    /// <summary>What is coloured, for each place: the deviation as a part of what is tolerated, the others as a part of the run's own largest; 0 where it
    /// is not known.</summary>
    public double[] Colours(RunMeasure measure)
    {
        var values = RunPlot.Values(Trace, measure);
        var whole = measure == RunMeasure.Deviation ? ToleranceMm : Trace.Places.Select((place, i) => place.ToolOn ? values[i] : 0.0).DefaultIfEmpty().Max();
        return whole > 0.0 ? [.. values.Select(value => value / whole)] : new double[values.Length];
    }
}

/// <summary>Collects where the machine is while a job runs on it, by what the job tells.</summary>
/// <remarks>On the job's thread.</remarks>
internal sealed class LiveTrace(PreparedJob job, bool isDryRun)
{
    /// <summary>The distance of a place from so many segments is not found on the side.</summary>
    private const int MostSegments = 50_000;

    /// <summary>Controller seconds between two pictures of it.</summary>
    private const double Between = 0.25;

    private readonly RunTraceBuilder _places = RunJudge.PlacesOf(job);
    private double _shown = double.NegativeInfinity;
    private CountsPoint? _error;

    /// <returns>Null for a drawing that is too large for it.</returns>
    public static LiveTrace? Of(PreparedJob job, bool isDryRun) => job.Analysed.Count > MostSegments ? null : new LiveTrace(job, isDryRun);

    /// <summary>The machine is here.</summary>
    /// <returns>The run so far when it is time to show it; otherwise null.</returns>
    public RecordedRun? Add(JobProgress told)
    {
        _error = told.Error ?? _error;
        _places.Add(RunJudge.Sample(job, told, isDryRun, _error));
        if (told.Seconds - _shown < Between) return null;
        _shown = told.Seconds;
        return new RecordedRun(job, _places.ToTrace("polled"));
    }
}
