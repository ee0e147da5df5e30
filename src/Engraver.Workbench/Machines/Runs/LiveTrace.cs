using Engraver.Core.Machines;
using Engraver.Core.Verification;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Machines.Runs;

/// <summary>Collects the trace of a running job from its progress.</summary>
/// <remarks>On the job's thread.</remarks>
internal sealed class LiveTrace(PreparedJob job, bool isDryRun)
{
    /// <summary>Maximum number of segments for which deviations are computed during a run.</summary>
    private const int MaxSegments = 50_000;

    /// <summary>Controller seconds between two updates of the display.</summary>
    private const double MinInterval = 0.25;

    private readonly RunTraceBuilder _places = RunJudge.PlacesOf(job);
    private double _shown = double.NegativeInfinity;
    private CountsPoint? _error;

    /// <returns>Null if the drawing is too large.</returns>
    public static LiveTrace? Of(PreparedJob job, bool isDryRun) => job.Analysed.Count > MaxSegments ? null : new LiveTrace(job, isDryRun);

    /// <summary>Adds a position.</summary>
    /// <returns>The run so far if the display is due; otherwise null.</returns>
    public RecordedRun? Add(JobProgress told)
    {
        _error = told.Error ?? _error;
        _places.Conditions = RunJudge.ConditionsOf(told);
        _places.Add(RunJudge.Sample(job, told, isDryRun, _error));
        if (told.Seconds - _shown < MinInterval) return null;
        _shown = told.Seconds;
        return new RecordedRun(job, _places.ToTrace("polled"));
    }
}
