using Engraver.Core.Machines;
using Engraver.Core.Motion;
using Engraver.Core.Verification;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Machines.Runs;

/// <summary>Compares a run over a real link with the drawing by its polled positions. Memory does not grow with the duration of the run.</summary>
/// <remarks>All data structures are built before the job starts, because building them for a large drawing would delay the heartbeat. Not thread
/// safe.</remarks>
internal sealed class PolledJudge
{
    private readonly PreparedJob _job;
    private readonly ITraceJudge _path;
    private readonly MotorJudge _motors;
    private readonly RunTraceBuilder _places;
    private TraceSample? _last;
    private CountsPoint? _error;
    private bool _hasCut;

    public PolledJudge(PreparedJob job)
    {
        (_job, _path, _places) = (job, RunJudge.JudgeOf(job), RunJudge.PlacesOf(job));
        var motors = RunJudge.PlanJudgeOf(job, null, RunJudge.Tolerances(job));
        _motors = new MotorJudge(() => motors);
    }

    /// <summary>Conditions of the places that are added from now on.</summary>
    public void SetConditions(TraceConditions conditions) => _places.Conditions = conditions;

    public void Add(TracePoint point)
    {
        var profile = _job.Settings.CuttingMachine;
        var commanded = RunJudge.CommandedSample(profile, point.Seconds, point.Place, point.ToolOn);
        ForwardLast(commanded.Cutting);
        _last = commanded;
        if (point.Error is not null) _motors.Add(commanded, RunJudge.MotorSample(profile, point));
        _error = point.Error ?? _error; // Between two queries the last answer is the best estimate.
        _places.Add(RunJudge.MotorSample(profile, point with { Error = _error }));
    }

    /// <summary>The trace of the machine.</summary>
    public RunTrace Trace() => _places.ToTrace("polled");

    /// <summary>Judges the positions and the segments counted by the controller; the current segment counts up to the last known position on it. Call once, at
    /// the end of the job.</summary>
    public RunJudgement Judge(MotionProgram program, JobResult result)
    {
        ForwardLast(isCutOn: true);
        _last = null;
        if (!_hasCut) return RunJudgement.Unknown;
        var found = _path.Verdict();
        var planned = program.Strokes.Sum(stroke => stroke.Sequences.Sum(sequence => sequence.Length));
        var tolerances = RunJudge.Tolerances(_job);
        var cut = result.LengthByStroke.Sum() + UnfinishedSegment.CutLength(program, result, tolerances.Deviation / tolerances.Count);
        var missing = _job.Settings.CuttingMachine.Scale.Finer.LengthOf(Math.Max(0.0, planned - cut));
        return RunJudge.WithMotors(new RunJudgement(found.MaxDeviation, result.IsEndKnown ? missing : null, "polled") { CornerDeviationMm = found.CornerDeviation, DeviationAt = found.DeviationAt?.Place }, _motors);
    }

    /// <summary>The last poll before the tool leaves the work may be the only one of the retract; the height judge recognises retracts and plunges by the
    /// preceding sample without a cut.</summary>
    private void ForwardLast(bool isCutOn)
    {
        if (_last is not { } last) return;
        _hasCut |= last.Cutting;
        if (last.Cutting && !isCutOn) _path.Add(last with { Cutting = false });
        _path.Add(last);
    }
}
