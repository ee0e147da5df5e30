using Engraver.Core.Diagnostics;
using Engraver.Core.Languages;
using Engraver.Core.Machines;
using Engraver.Galil.Jobs.Journal;
using Engraver.Galil.Language;

namespace Engraver.Galil.Jobs;

/// <summary>Reports the job's progress to the operator and the journal.</summary>
internal sealed class JobLog(JobMachine machine, JobLedger ledger, JobJournal journal, IProgress<JobProgress>? progress, TimeProvider time, Action<Diagnostic>? told)
{
    /// <summary>Controller seconds between two lines of the journal inside one sequence.</summary>
    private const double JournalSeconds = 0.25;

    /// <summary>Controller seconds between two reports to the operator.</summary>
    private const double ProgressSeconds = 0.05;

    private double _reported = double.NegativeInfinity;
    private double _journalled;
    private bool _isBegun;

    /// <param name="program">The fingerprint of the whole program.</param>
    /// <exception cref="IOException">A journal cannot be written, its own or that of the job with which it goes on.</exception>
    /// <exception cref="UnauthorizedAccessException">It may not be written.</exception>
    public void Begin(JobOptions options, string controller, string program)
    {
        var at = machine.State.Position;
        journal.BeginJob();
        journal.Write(new JournalHeader(
            options.DrawingName, controller, options.Mode(), ledger.SegmentCount, at.X, at.Y, machine.Frame.X, machine.Frame.Y, time.GetUtcNow())
        {
            Axes = machine.Profile.Axes.Letters,
            StartZ = at.Z,
            FrameZ = machine.Frame.Z,
            HeightOfCut = machine.Profile is { Height: null, Axes.Z: not null } ? options.HeightOfCut ?? at.Z : null,
            Program = program,
            Settings = options.Settings,
            Mark = machine.Mark,
            DryRun = options.DryRun,
            FromSegments = options.From.Segments,
            FromAlong = options.From.Along,
        });
        TellResumed(options);
        journal.Keep();
        _isBegun = true;
    }

    /// <summary>A job that was begun is not ended because its journal cannot be written: the part would be lost for it.</summary>
    private void Write<T>(T line)
    {
        try
        {
            journal.Write(line);
        }
        catch (IOException failure) when (_isBegun)
        {
            var reason = SystemReason.Of(failure);
            journal.GiveUp(reason);
            var finding = PreparationRules.JournalGivenUp.At(default, reason);
            if (told is null) ledger.Warnings.Add(finding);
            else told(finding);
        }
    }

    /// <summary>An interrupted job that is gone on with is not gone on with a second time from its own place. A dry run cuts nothing.</summary>
    private static void TellResumed(JobOptions options)
    {
        if (options is not { ResumedJournal: { } earlier, JournalPath: { } own, DryRun: false } || Path.GetFullPath(earlier) == Path.GetFullPath(own)) return;
        using var told = new JobJournal(earlier);
        told.Write(new JournalResumed(Path.GetFullPath(own)));
    }

    /// <summary>Written before anything in the controller is changed.</summary>
    public void Found(JournalFound found) => journal.Write(found);

    public void Polled()
    {
        if (machine.Seconds - _journalled >= JournalSeconds) WriteProgress();
        if (machine.Seconds - _reported < ProgressSeconds) return;
        _reported = machine.Seconds;
        Report();
    }

    /// <summary>The operator held the job or let it go on, or an override came in force.</summary>
    public void ControlChanged()
    {
        if (machine.Known is null) return;
        var at = machine.State.Position;
        Write(new JournalControl(machine.Hold.Phase, machine.Hold.Speed.Override, machine.Hold.RapidRatio, at.X, at.Y, machine.Seconds));
        Report();
    }

    /// <summary>What the controller counts from now on belongs to this.</summary>
    public void Opened(int first, IReadOnlyList<int> starts, int calls) => Write(new JournalOpened(first, starts, calls));

    /// <summary>The present sequence is complete.</summary>
    public void SequenceDone() => WriteProgress();

    public void End(JobResult result)
    {
        journal.Write(new JournalEnd(result.Outcome, result.Sentence, result.SegmentsExecuted, result.FinalPosition?.X, result.FinalPosition?.Y, result.Seconds, result.NotRestored.Count == 0)
        {
            Cut = result.Place.Segments,
            Along = Math.Round(result.Place.Along, 1),
        });
        if (machine.Known is not null) Report();
    }

    private void WriteProgress()
    {
        _journalled = machine.Seconds;
        var at = machine.State.Position;
        var entity = ledger.Entities.Count == 0 ? -1 : ledger.Entities[^1];
        var place = ledger.Place;
        Write(new JournalProgress(ledger.Stroke, ledger.Sequence, entity, ledger.Executed, at.X, at.Y, machine.Seconds) { Cut = place.Segments, Along = Math.Round(place.Along, 1) });
    }

    private void Report() => progress?.Report(new JobProgress(
        ledger.Stroke, ledger.Sent, ledger.Executed, ledger.SegmentCount, machine.Here, machine.IsToolOn, machine.Seconds, machine.State.Outputs)
    {
        Phase = machine.Hold.Phase,
        IsOnPath = machine.State.SequenceRunning,
        Error = machine.FollowingError,
        FeedRatio = machine.Hold.Speed.Override,
        RapidRatio = machine.Hold.RapidRatio,
    });
}
