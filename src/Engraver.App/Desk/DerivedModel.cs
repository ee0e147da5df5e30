using Engraver.Core.Diagnostics;
using Engraver.Core.Sequencing;
using Engraver.Workbench.Commands;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Machines;
using Engraver.Workbench.Playback;

namespace Engraver.App.Desk;

/// <summary>What follows from the document, and where the tool of the playback stands in it, as the palettes want it. UI thread only.</summary>
public sealed class DerivedModel(CommandSession session)
{
    /// <summary>Seconds of the plan; a smaller step does not move the playback, which an operator may look through while the job is held.</summary>
    private const double LeastStep = 0.001;

    private PostedLines _lines = PostedLines.None;
    private bool _follows;

    /// <summary>What the machine told last of the job that is planned here, and to which moment of the plan it had come then.</summary>
    private EngravedProgress? _told;
    private double _reached;

    /// <summary>Raised after the tool of the playback has moved.</summary>
    public event Action? Moved;

    /// <summary>Raised when a program begins to be written in the background; the task ends when it is there.</summary>
    public event Action<Task>? Posting;

    /// <summary>The playback follows a job that runs on the machine.</summary>
    public bool FollowsMachine => _follows;

    public DerivedDocument Current { get; private set; } = DerivedDocument.Nothing;

    public PreparedJob? Job => Current.Job;

    public SequencingResult? Sequence => Current.Sequence;

    public IReadOnlyList<Diagnostic> Findings => Current.Findings;

    public double TotalSeconds => Current.Motion?.DurationSeconds ?? 0.0;

    /// <summary>How long the job takes over the link that the machine is connected by, seconds; 0 without a plan. The playback shows it as over a
    /// network.</summary>
    public double PlannedSeconds => Current.Plan?.Total ?? 0.0;

    public double AtSeconds => Moment?.Seconds ?? 0.0;

    /// <summary>What the tool of the playback does at its place; null without a plan.</summary>
    public PlaybackMoment? Moment { get; private set; }

    /// <summary>Row of the sequenced table; -1 for none.</summary>
    public int RowUnderTool => Moment?.Row ?? -1;

    public int StrokeUnderTool => Moment?.Stroke ?? -1;

    /// <summary>Index into <see cref="ProgramLines"/>; -1 for none, and while they are not there.</summary>
    public int LineUnderTool => HasLines && Moment is { } at ? _lines.Motion!.LineOf(at.Segment) - 1 : -1;

    /// <summary>The lines of the present program are there.</summary>
    internal bool HasLines => _lines.Lines.Count > 0 && ReferenceEquals(_lines.Motion, Current.Motion);

    /// <summary>Completes when the program that was asked for is written.</summary>
    internal Task Written => _lines.Written;

    /// <summary>The posted program in lines; the same list as long as it is the same program. Only a page that is seen asks: the first question has the
    /// program written, a long one in the background.</summary>
    public IReadOnlyList<string> ProgramLines()
    {
        if (ReferenceEquals(_lines.Motion, Current.Motion)) return _lines.Lines;
        _lines = PostedLines.Of(Current);
        if (!_lines.Written.IsCompleted) Posting?.Invoke(_lines.Written);
        return _lines.Lines;
    }

    /// <summary>Forgets the lines of a program that is no longer the present one.</summary>
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

    /// <summary>What the plan says is left of a job, seconds; dwells at their true length, the exchange over a serial line spread evenly.</summary>
    public double SecondsLeft(EngravedProgress told) => (1.0 - FractionDone(told)) * PlannedSeconds;

    /// <summary>How much of the planned time of a job is over, 0 to 1. Of a job that is not the one that is planned here: of its segments.</summary>
    public double FractionDone(EngravedProgress told) => IsPlannedHere(told) && Current.Motion is { DurationSeconds: > 0.0 } motion ? SecondsDone(motion, told) / motion.DurationSeconds : told.Fraction;

    /// <summary>How much longer the plan takes under overrides; less than 1 for shorter.</summary>
    public double TimeUnder(double feed, double rapid) => Current.Plan is { Total: > 0.0 } plan ? plan.Under(feed, rapid) / plan.Total : 1.0;

    /// <summary>Takes the present state of derivation and playback.</summary>
    internal void Look()
    {
        Current = session.Derivation.Current;
        ForgetOldLines();
        if (!ReferenceEquals(session.Playback.Motion, Current.Motion)) session.Playback.Load(Current.Motion);
        var runs = FollowMachine();
        LookWhereToolIs();
        if (!runs) _follows = false;
    }

    /// <summary>Asks the playback where the tool is.</summary>
    internal void LookWhereToolIs()
    {
        var moment = session.Playback.Moment;
        if (moment == Moment) return;
        Moment = moment;
        Moved?.Invoke();
    }

    /// <summary>While the job that is planned here runs, and once more at its end, the playback is put where the machine has come to.</summary>
    /// <returns>True while a job runs.</returns>
    private bool FollowMachine()
    {
        var status = session.Machine.Status;
        var runs = status.State.IsJob();
        if (!runs && !FollowsMachine) return false;
        if (Current.Motion is not { } motion || status.Progress is not { } told || !IsPlannedHere(told)) return runs;
        if (!_follows)
        {
            session.Playback.Pause();
            (_follows, _told) = (true, null);
        }

        var now = SecondsDone(motion, told);
        if (_told is null || Math.Abs(now - _reached) >= LeastStep) session.Playback.Follow(_reached = now);
        _told = told;
        return runs;
    }

    /// <summary>The job that runs is the one that is planned here, not one of trajectories or one fitted to a slow line.</summary>
    private bool IsPlannedHere(EngravedProgress told) => Current.Motion?.SegmentCount == told.SegmentCount && session.Machine.Runs.ShownJob?.Followed is null;

    /// <summary>To which moment of the plan the machine has come: in a segment as far as it has come along it, between strokes to the next segment. In a
    /// segment that is begun it is not farther back than it was (held and moved away, or stopped).</summary>
    private double SecondsDone(PlannedMotion motion, EngravedProgress told)
    {
        if (told.SegmentsDone >= motion.SegmentCount) return motion.DurationSeconds;
        var now = told.IsOnPath ? motion.TimeOfPlace(told.SegmentsDone, told.Position) : motion.TimeOfSegment(told.SegmentsDone);
        return _told?.SegmentsDone == told.SegmentsDone ? Math.Max(now, _reached) : now;
    }
}
