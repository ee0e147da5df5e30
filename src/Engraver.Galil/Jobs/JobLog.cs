using Engraver.Core.Diagnostics;
using Engraver.Core.Languages;
using Engraver.Core.Machines;
using Engraver.Galil.Jobs.Journal;
using Engraver.Galil.Language;

namespace Engraver.Galil.Jobs;

/// <summary>Reports the job's progress to the operator and the journal.</summary>
internal sealed class JobLog(JobLedger ledger, JobJournal journal, IProgress<JobProgress>? progress, TimeProvider time, Action<Diagnostic>? report)
{
    /// <summary>Controller seconds between two lines of the journal inside one sequence.</summary>
    private const double JournalSeconds = 0.25;

    /// <summary>Controller seconds between two reports to the operator.</summary>
    private const double ProgressSeconds = 0.05;

    private double _reported = double.NegativeInfinity;
    private double _journalled;
    private bool _isBegun;
    private (long Timestamp, TimeSpan Busy)? _lastLoad;

    /// <param name="program">The fingerprint of the whole program.</param>
    /// <exception cref="IOException">A journal cannot be written: that of this job, or that of the job that it resumes.</exception>
    /// <exception cref="UnauthorizedAccessException">It may not be written.</exception>
    public void Begin(JobMachine machine, JobOptions options, string controller, string program)
    {
        var at = machine.State.Position;
        journal.BeginJob();
        journal.Write(new JournalHeader(
            options.DrawingName, controller, options.Mode(), ledger.SegmentCount, at.X, at.Y, machine.Frame.Origin.X, machine.Frame.Origin.Y, time.GetUtcNow())
        {
            Axes = machine.Profile.Axes.Letters,
            StartZ = at.Z,
            FrameZ = machine.Frame.Origin.Z,
            HeightOfCut = machine.Profile is { Height: null, Axes.Z: not null } ? options.HeightOfCut ?? at.Z : null,
            Program = program,
            Settings = options.Settings,
            Mark = machine.Mark,
            DryRun = options.DryRun,
            FromSegments = options.From.Segments,
            FromAlong = options.From.Along,
        });
        NoteResumed(options);
        journal.Keep();
        _isBegun = true;
    }

    /// <summary>A job that has started is not ended because its journal cannot be written: the part would be lost.</summary>
    private void Write<T>(T line)
    {
        try
        {
            journal.Write(line);
        }
        catch (IOException failure) when (_isBegun)
        {
            var reason = SystemErrorText.FromException(failure);
            journal.GiveUp(reason);
            var finding = PreparationRules.JournalGivenUp.At(default, reason);
            if (report is null) ledger.Warnings.Add(finding);
            else report(finding);
        }
    }

    /// <summary>An interrupted job that is resumed cannot be resumed a second time from the same place. A dry run cuts nothing.</summary>
    private static void NoteResumed(JobOptions options)
    {
        if (options is not { ResumedJournal: { } earlier, JournalPath: { } own, DryRun: false } || Path.GetFullPath(earlier) == Path.GetFullPath(own)) return;
        using var resumed = new JobJournal(earlier);
        resumed.Write(new JournalResumed(Path.GetFullPath(own)));
    }

    /// <summary>Written before anything in the controller is changed.</summary>
    public void Found(JournalFound found) => journal.Write(found);

    /// <summary>Call with each poll.</summary>
    public void Polled(JobMachine machine)
    {
        if (machine.Seconds - _journalled >= JournalSeconds) WriteProgress(machine);
        if (machine.Seconds - _reported < ProgressSeconds) return;
        _reported = machine.Seconds;
        Report(machine);
    }

    /// <summary>The operator held or resumed the job, or an override came in force.</summary>
    public void ControlChanged(JobMachine machine)
    {
        if (machine.Known is null) return;
        var at = machine.State.Position;
        Write(new JournalControl(machine.Hold.Phase, machine.Speed.Override, machine.Speed.RapidRatio, at.X, at.Y, machine.Seconds));
        Report(machine);
    }

    /// <summary>What the controller counts from now on belongs to this sequence, call or program.</summary>
    public void Opened(JournalOpened opened) => Write(opened);

    /// <summary>The present sequence is complete.</summary>
    public void SequenceDone(JobMachine machine) => WriteProgress(machine);

    public void End(JobMachine machine, JobResult result)
    {
        journal.Write(new JournalEnd(result.Outcome, result.Message, result.SegmentsExecuted, result.FinalPosition?.X, result.FinalPosition?.Y, result.Seconds, result.NotRestored.Count == 0)
        {
            Cut = result.Place.Segments,
            Along = Math.Round(result.Place.Along, 1),
        });
        if (machine.Known is not null) Report(machine);
    }

    private void WriteProgress(JobMachine machine)
    {
        _journalled = machine.Seconds;
        var at = machine.State.Position;
        var entity = ledger.Entities.Count == 0 ? -1 : ledger.Entities[^1];
        var place = ledger.Place;
        Write(new JournalProgress(ledger.Stroke, ledger.Sequence, entity, ledger.Executed, at.X, at.Y, machine.Seconds) { Cut = place.Segments, Along = Math.Round(place.Along, 1) });
    }

    private void Report(JobMachine machine) => progress?.Report(new JobProgress(
        ledger.Stroke, ledger.Sent, ledger.Executed, ledger.SegmentCount, machine.Here, machine.IsToolOn, machine.Seconds, machine.State.Outputs)
    {
        Phase = machine.Hold.Phase,
        IsOnPath = machine.State.SequenceRunning,
        Error = machine.State.Error,
        FeedRatio = machine.Speed.Override,
        RapidRatio = machine.Speed.RapidRatio,
        LinkLoad = progress is null ? null : NextLinkLoad(machine),
    });

    /// <summary>Part of the time since the last call in which the command handle was busy; null at the first call, and when no time has passed.</summary>
    private double? NextLinkLoad(JobMachine machine)
    {
        var (now, last) = ((Timestamp: time.GetTimestamp(), Busy: machine.LinkBusy), _lastLoad);
        _lastLoad = now;
        if (last is not { } before || now.Timestamp <= before.Timestamp) return null;
        return Math.Clamp((now.Busy - before.Busy) / time.GetElapsedTime(before.Timestamp, now.Timestamp), 0.0, 1.0);
    }
}
