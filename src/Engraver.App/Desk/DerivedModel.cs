using Engraver.Core.Diagnostics;
using Engraver.Core.Sequencing;
using Engraver.Workbench.Commands;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Machines;
using Engraver.Workbench.Playback;

namespace Engraver.App.Desk;

/// <summary>The results derived from the document and the position of the playback in them, as the palettes show them. UI thread only.</summary>
public sealed class DerivedModel(CommandSession session)
{
    /// <summary>Seconds of the plan; a smaller step does not move the playback, so that an operator can browse it while the job is held.</summary>
    private const double MinStep = 0.001;

    private PostedLines _lines = PostedLines.None;
    private bool _wasFollowing;

    /// <summary>Last reported progress of the job that is planned here, and the time of the plan that it had reached then.</summary>
    private EngravedProgress? _lastProgress;
    private double _reachedSeconds;

    /// <summary>Raised after the tool of the playback has moved.</summary>
    public event Action? ToolMoved;

    /// <summary>Raised when a program starts to be written in the background; the task ends when it is complete.</summary>
    public event Action<Task>? Posting;

    /// <summary>The playback follows a job that runs on the machine.</summary>
    public bool FollowsMachine => _wasFollowing;

    public DerivedDocument Current { get; private set; } = DerivedDocument.Nothing;

    public PreparedJob? Job => Current.Job;

    public SequencingResult? Sequence => Current.Sequence;

    public IReadOnlyList<Diagnostic> Findings => Current.Findings;

    public double TotalSeconds => Current.Motion?.DurationSeconds ?? 0.0;

    /// <summary>Duration of the job over the connected link, seconds; 0 without a plan. The playback shows the duration over a network.</summary>
    public double PlannedSeconds => Current.Plan?.Total ?? 0.0;

    public double AtSeconds => Moment?.Seconds ?? 0.0;

    /// <summary>The state of the playback at its position; null without a plan.</summary>
    public PlaybackMoment? Moment { get; private set; }

    /// <summary>Row of the sequenced table; -1 for none.</summary>
    public int RowUnderTool => Moment?.Row ?? -1;

    public int StrokeUnderTool => Moment?.Stroke ?? -1;

    /// <summary>Index into <see cref="ProgramLines"/>; -1 for none, and while the lines do not exist yet.</summary>
    public int LineUnderTool => HasLines && Moment is { } at ? _lines.Motion!.LineOf(at.Segment) - 1 : -1;

    /// <summary>The lines of the current program exist.</summary>
    internal bool HasLines => _lines.Lines.Count > 0 && ReferenceEquals(_lines.Motion, Current.Motion);

    /// <summary>Completes when the requested program is written.</summary>
    internal Task Written => _lines.Written;

    /// <summary>The lines of the posted program; the same list as long as the program is the same. Only visible pages call this: the first call starts
    /// writing the program, a long one in the background.</summary>
    public IReadOnlyList<string> ProgramLines()
    {
        if (ReferenceEquals(_lines.Motion, Current.Motion)) return _lines.Lines;
        _lines = PostedLines.Of(Current);
        if (!_lines.Written.IsCompleted) Posting?.Invoke(_lines.Written);
        return _lines.Lines;
    }

    /// <summary>Discards the lines of a program that is no longer current.</summary>
    private void ForgetOldLines()
    {
        if (!ReferenceEquals(_lines.Motion, Current.Motion)) _lines = PostedLines.None;
    }

    public void MoveToRow(int row)
    {
        if (row != RowUnderTool) session.Playback.GoToRow(row);
    }

    public void MoveToStroke(int stroke)
    {
        if (stroke != StrokeUnderTool) session.Playback.GoToStroke(stroke);
    }

    public void MoveToLine(int line)
    {
        if (line != LineUnderTool) session.Playback.GoToLine(line + 1);
    }

    public void MoveToEntity(int entity) => session.Playback.GoToEntity(entity);

    public void MoveTo(double seconds)
    {
        if (seconds != AtSeconds) session.Playback.Scrub(seconds);
    }

    /// <summary>Planned remaining time of a job, seconds; dwells at their true length, the exchange over a serial line spread evenly.</summary>
    public double SecondsLeft(EngravedProgress progress) => (1.0 - FractionDone(progress)) * PlannedSeconds;

    /// <summary>Elapsed fraction of the planned time of a job, 0 to 1. For a job other than the planned one: fraction of its segments.</summary>
    public double FractionDone(EngravedProgress progress) => IsPlannedHere(progress) && Current.Motion is { DurationSeconds: > 0.0 } motion ? SecondsDone(motion, progress) / motion.DurationSeconds : progress.Fraction;

    /// <summary>Factor by which the planned time grows under overrides; less than 1 if it shrinks.</summary>
    public double TimeFactor(double feed, double rapid) => Current.Plan is { Total: > 0.0 } plan ? plan.Under(feed, rapid) / plan.Total : 1.0;

    /// <summary>Takes the current state of derivation and playback.</summary>
    internal void Refresh()
    {
        Current = session.Derivation.Current;
        ForgetOldLines();
        if (!ReferenceEquals(session.Playback.Motion, Current.Motion)) session.Playback.Load(Current.Motion);
        var runs = FollowMachine();
        RefreshToolPosition();
        if (!runs) _wasFollowing = false;
    }

    /// <summary>Queries the position of the playback.</summary>
    internal void RefreshToolPosition()
    {
        var moment = session.Playback.Moment;
        if (moment == Moment) return;
        Moment = moment;
        ToolMoved?.Invoke();
    }

    /// <summary>While the planned job runs, and once at its end, moves the playback to the position of the machine.</summary>
    /// <returns>True while a job runs.</returns>
    private bool FollowMachine()
    {
        var status = session.Machine.Status;
        var runs = status.State.IsJob();
        if (!runs && !FollowsMachine) return false;
        if (Current.Motion is not { } motion || status.Progress is not { } progress || !IsPlannedHere(progress)) return runs;
        if (!_wasFollowing)
        {
            session.Playback.Pause();
            (_wasFollowing, _lastProgress) = (true, null);
        }

        var now = SecondsDone(motion, progress);
        if (_lastProgress is null || Math.Abs(now - _reachedSeconds) >= MinStep) session.Playback.Follow(_reachedSeconds = now);
        _lastProgress = progress;
        return runs;
    }

    /// <summary>The running job is the planned one, not one of trajectories or one fitted to a slow line.</summary>
    private bool IsPlannedHere(EngravedProgress progress) => Current.Motion?.SegmentCount == progress.SegmentCount && session.Machine.Runs.ShownJob?.Trajectories is null;

    /// <summary>The time of the plan that the machine has reached: inside a segment by the distance along it, between strokes at the next segment. Within
    /// one segment it does not go back (after a hold with moves away, or a stop).</summary>
    private double SecondsDone(PlannedMotion motion, EngravedProgress progress)
    {
        if (progress.SegmentsDone >= motion.SegmentCount) return motion.DurationSeconds;
        var now = progress.IsOnPath ? motion.TimeOfPlace(progress.SegmentsDone, progress.Position) : motion.TimeOfSegment(progress.SegmentsDone);
        return _lastProgress?.SegmentsDone == progress.SegmentsDone ? Math.Max(now, _reachedSeconds) : now;
    }
}
