using Engraver.Core.Languages;
using Engraver.Core.Machines;
using Engraver.Core.Motion;
using Engraver.Galil.Jobs.Execution;
using Engraver.Galil.Language;
using Engraver.Galil.Programs.Resident;
using Engraver.Galil.Protocol;
using Engraver.Galil.Sessions;

namespace Engraver.Galil.Jobs.Journal;

/// <summary>Finds where an interrupted job is to be resumed: by its journal and, where the watchdog stopped the machine because the host or the link was
/// lost, by what the watchdog left in the controller's variables.</summary>
internal static class ResumeFinder
{
    /// <summary>A position further from the path than this is not on it, counts.</summary>
    private const double OnPath = 2.5;

    /// <summary>The trip switches the tool off and then reads the place, statement by statement: at 0.5 ms a line (galil-dmc.md A.4) the place is up to this
    /// much after the end of the cut, seconds.</summary>
    private const double TripSeconds = 0.005;

    /// <exception cref="ControllerException">The link failed.</exception>
    public static async Task<ResumePosition> FindAsync(CommandChannel channel, MotionProgram program, JobMode mode, string journal, CancellationToken cancellation)
    {
        var job = Read(journal, out var refused);
        if (job is null || (refused = Unfit(job, program, mode)).Length > 0) return ResumePosition.Refused(refused) with { Strategy = job?.Header.Mode.Strategy(), Settings = job?.Header.Settings, IsPathChanged = job is not null && Unfit(job, mode).Length == 0 };
        var witness = new JournalWitness(job, program);
        if (witness.WhyNotThere() is { Length: > 0 } elsewhere) return ResumePosition.Refused(elsewhere);
        var kept = await AskAsync(channel, ResidentProgram.Variables.JobMark, cancellation).ConfigureAwait(false);
        var tripped = await AskAsync(channel, ResidentProgram.Variables.TripMark, cancellation).ConfigureAwait(false);
        var frame = new CountsPoint(job.Header.FrameX, job.Header.FrameY);
        var isToolChange = job.End?.Outcome == JobOutcome.ToolChange;
        var found = new ResumePosition(job.Place, 0.0, frame, Math.Abs(kept ?? 0.0) == job.Header.Mark || tripped == job.Header.Mark) { Strategy = mode.Strategy(), HeightOfCut = isToolChange ? null : job.Header.HeightOfCut, IsToolChange = isToolChange, Settings = job.Header.Settings, IsUnsealed = job.IsUnsealed };
        var sequences = kept == job.Header.Mark ? await AskAsync(channel, ResidentProgram.Variables.Sequence, cancellation).ConfigureAwait(false) : null;
        if (witness.WhyNotCounted(sequences) is { Length: > 0 } contradicted) return ResumePosition.Refused(contradicted);
        if (tripped != job.Header.Mark || job.Opened is not { } opened) return found;
        if (await TripAsync(channel, program, job, opened, frame, cancellation).ConfigureAwait(false) is not var (trip, at)) return found;
        if (witness.WhyNotReached(trip, at) is { Length: > 0 } passed) return ResumePosition.Refused(passed);
        return trip > job.Place ? found with { Place = trip, Doubt = TripSeconds * Speed(program, trip) } : found;
    }

    /// <summary>The place at which the watchdog switched the tool off, or began to brake a tool that an axis drives.</summary>
    private static async Task<(JobPosition Place, CountsPoint At)?> TripAsync(CommandChannel channel, MotionProgram program, InterruptedJob job, JournalOpened opened, CountsPoint frame, CancellationToken cancellation)
    {
        var counter = await AskAsync(channel, ResidentProgram.Variables.TripCounter, cancellation).ConfigureAwait(false);
        var calls = await AskAsync(channel, ResidentProgram.Variables.Sequence, cancellation).ConfigureAwait(false);
        var x = await AskAsync(channel, ResidentProgram.Variables.TripX, cancellation).ConfigureAwait(false);
        var y = await AskAsync(channel, ResidentProgram.Variables.TripY, cancellation).ConfigureAwait(false);
        var isTall = program.Profile.Height is not null;
        var z = isTall ? await AskAsync(channel, ResidentProgram.Variables.TripZ, cancellation).ConfigureAwait(false) : 0.0;
        if (counter is null || calls is null || x is null || y is null || z is null) return null;
        var within = job.Header.Mode switch
        {
            JobMode.Stream => opened.Done((int)counter),
            JobMode.Calls => calls > opened.Calls ? 1 : 0,
            _ => ChunkProgress.Within(opened.Starts, (int)calls, (int)counter),
        };
        var at = new CountsPoint((int)x - frame.X, (int)y - frame.Y, isTall ? (int)z - job.Header.FrameZ : 0);
        return (ProgramPositionFinder.Find(program, opened.First + within, at, OnPath), at);
    }

    /// <summary>Reads the journal, and makes sure that it can be written: otherwise it could not be noted there that its job was resumed, and the job
    /// could be resumed a second time from the same place.</summary>
    private static InterruptedJob? Read(string path, out string refused)
    {
        var writing = false;
        try
        {
            var job = InterruptedJob.Read(path);
            refused = job is null ? Wording.Get("Resume.NoJob") : "";
            writing = true;
            using var tried = new FileStream(path, FileMode.Open, FileAccess.Write, FileShare.ReadWrite);
            return job;
        }
        catch (Exception failure) when (failure is IOException or UnauthorizedAccessException)
        {
            refused = Wording.Get(writing ? "Resume.Unwritable" : "Resume.Unreadable", SystemErrorText.FromException(failure));
            return null;
        }
    }

    /// <summary>Why this program cannot resume that job; empty when it can.</summary>
    private static string Unfit(InterruptedJob job, MotionProgram program, JobMode mode) =>
        Unfit(job, mode) is { Length: > 0 } unfit ? unfit
        : job.Header.Program == ProgramFingerprint.Of(program) ? ""
        : Wording.Get("Resume.OtherProgram", job.Header.Drawing);

    /// <summary>The same, whatever the program.</summary>
    private static string Unfit(InterruptedJob job, JobMode mode) => job switch
    {
        { Fault: { Length: > 0 } fault } => fault,
        { NotResumableReason: { Length: > 0 } over } => over,
        { Header.Mode: var other } when other != mode => Wording.Get("Resume.OtherMode", other.Strategy().Key, mode.Strategy().Key),
        _ => "",
    };

    private static double Speed(MotionProgram program, JobPosition place) => program.SpeedAfter(place.Segments) * JobControl.FeedRange.Max;

    private static async Task<double?> AskAsync(CommandChannel channel, string variable, CancellationToken cancellation) => (await channel.ReadAsync(variable, cancellation).ConfigureAwait(false)).ValuesOrEmpty;
}
