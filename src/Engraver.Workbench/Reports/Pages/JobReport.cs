using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.Languages;
using Engraver.Core.Machines;
using Engraver.Core.Motion;
using Engraver.Core.Verification;
using Engraver.Workbench.Certificates;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Files;
using Engraver.Workbench.Histories;
using Engraver.Workbench.Machines.Runs;
using Engraver.Workbench.Playback;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Reports.Pages;

/// <summary>Everything that the page of a job tells: the job, its plan and cost, its certificate, and the run where there was one.</summary>
/// <param name="Job">Prepared in the style of <paramref name="Mode"/>.</param>
/// <param name="Certificate">How the job stands to the certificate beside its drawing.</param>
/// <param name="Now">When the page is made.</param>
public sealed record JobReport(PreparedJob Job, JobMode Mode, CertificateStanding Certificate, DateTimeOffset Now)
{
    /// <summary>The motion, made fit for the link; null when nothing can be cut.</summary>
    public MotionProgram? Program { get; private init; }

    /// <summary>The planned times of the program, over the link.</summary>
    public MotionTimes Times { get; private init; }

    /// <summary>Null where nobody says what the machine costs.</summary>
    public JobCost? Cost { get; private init; }

    /// <summary>The planned motion over time; null when nothing can be cut.</summary>
    public PlannedMotion? Motion { get; private init; }

    /// <summary>Findings of every stage, errors first, in the words of the place where they are read.</summary>
    public IReadOnlyList<Diagnostic> Findings { get; private init; } = [];

    /// <summary>How the job stands to the certificates of other targets that are beside its drawing, by target and dialect.</summary>
    public IReadOnlyList<(string Target, CertificateStanding Standing)> OtherCertificates { get; private init; } = [];

    /// <summary>The run that the page is about; null for a job that has not been run, or that the history does not know.</summary>
    public HistoryEntry? Run { get; private init; }

    /// <summary>What the journal alone tells of a run that the history does not know; null where it knows it, or there is no journal.</summary>
    public JournalledRun? Journalled { get; private init; }

    /// <summary>The file of <see cref="Journalled"/>, and whether its job is the one of the page.</summary>
    public (string File, bool IsThisJob) Journal { get; private init; }

    /// <summary>What has changed since that run, as a certificate tells it; empty where the run is of just this job, or there is none.</summary>
    public IReadOnlyList<string> RunDiffers { get; private init; } = [];

    /// <summary>Where the machine was in that run; null where it was not kept.</summary>
    public RunTrace? Trace { get; private init; }

    /// <summary>Why a kept trace cannot be shown; null where it can, or where there is none.</summary>
    public string? TraceProblem { get; private init; }

    /// <summary>Puts it together.</summary>
    /// <exception cref="SettingException">A named layer or the entering entity is not in the drawing.</exception>
    /// <exception cref="OperationCanceledException">The caller cancelled.</exception>
    public static JobReport Create(JobReportRequest request, CancellationToken cancellation)
    {
        ArgumentNullException.ThrowIfNull(request);
        var job = JobPreparation.PrepareUnlessCancelled(request.Drawing, request.Settings, JobPlan.StyleOf(request.Mode), cancellation);
        var fit = job.Motion.Program is { } planned ? JobPlan.FitToLink(planned, request.Address, request.Mode, job.Drawing) : null;
        var program = fit?.Program;
        var times = program is null ? default : JobPlan.PlannedTimes(program, request.Address, request.Mode);
        var standing = program is null ? CertificateStanding.None : CertificateStanding.OfRun(job, program);
        cancellation.ThrowIfCancellationRequested();
        var report = new JobReport(job, request.Mode, standing, request.Now)
        {
            Program = program,
            Times = times,
            Cost = program is null ? null : JobSheet.Of(job, times, request.Rates ?? request.Settings.Machine.Rates).Cost,
            Motion = program is { SegmentCount: > 0 } ? PlannedMotion.Create(program, job.Toolpath, MachineFamilies.Driver.NetworkTimes, null, cancellation) : null,
            Findings = [.. job.Diagnostics.Concat(fit?.Diagnostics ?? []).OrderByDescending(found => found.Severity).Select(request.Spell)],
            OtherCertificates = [.. OthersOf(request, JobPlan.StyleOf(request.Mode), cancellation)],
            Run = request.Run,
            RunDiffers = request.Run is { } run ? JobIdentity.Of(request.Drawing, request.Settings, "", () => null).Differences(run.DrawingSha256, run.Settings, run.ProfileHash) : [],
        };
        if (request.Journal is not { } journal) return report;
        report = report.WithTrace(journal);
        return request.Run is null && JournalledRun.Read(journal) is { } told ? report with { Journalled = told, Journal = (Path.GetFullPath(journal), IsOf(told, program, job)) } : report;
    }

    /// <summary>Whether the journal is of the job; one that was run in the other style had other segments.</summary>
    private static bool IsOf(JournalledRun told, MotionProgram? program, PreparedJob job)
    {
        if (told.Program.Length == 0) return true;
        if (program is not null && ProgramFingerprint.Of(program) == told.Program) return true;
        return JobPlan.StyleOf(told.Mode) != program?.Style && JobPreparation.Prepare(job.Drawing, job.Settings, JobPlan.StyleOf(told.Mode)).Motion.Program is { } other && ProgramFingerprint.Of(other) == told.Program;
    }

    private static IEnumerable<(string, CertificateStanding)> OthersOf(JobReportRequest request, MotionStyle sent, CancellationToken cancellation)
    {
        var hash = new Lazy<string?>(() => ContentHash.OfFile(request.Drawing.FileName));
        foreach (var (entry, dialect) in PostTable.All.Where(entry => entry.Reader is not null && entry.Post.Motion != sent).SelectMany(entry => entry.Dialects.Keys.Cast<string?>().Prepend(null), (entry, dialect) => (entry, dialect)))
        {
            cancellation.ThrowIfCancellationRequested();
            var path = CertificateFile.PathOf(request.Drawing.FileName, entry.Post.Name, dialect);
            if (!File.Exists(path)) continue;
            var job = new CertificationRequest(request.Drawing, hash.Value, request.Settings, entry, request.Now) { Dialect = dialect, Address = request.Address, Mode = request.Mode };
            yield return ($"{entry.Post.Name} {dialect}".TrimEnd(), CertificateStanding.Of(path, Certification.IdentityOf(job)));
        }
    }

    private JobReport WithTrace(string journal)
    {
        try
        {
            var trace = KeptTrace.Read(journal);
            return trace.CanBeOf(DrawnFingerprint.Of(Job.Analysed.ToSegments())) ? this with { Trace = trace } : this with { TraceProblem = Wording.Get("Trace.OtherDrawing", Path.GetFileName(Job.Drawing.FileName)) };
        }
        catch (Exception unreadable) when (unreadable is IOException or UnauthorizedAccessException or FormatException)
        {
            return this with { TraceProblem = SystemReason.Of(unreadable) };
        }
    }
}

/// <summary>Of what a page is made.</summary>
public sealed record JobReportRequest(Drawing Drawing, DrawingSettings Settings, JobMode Mode, DateTimeOffset Now)
{
    /// <summary>The link that the job goes over; null for a network.</summary>
    public ControllerAddress? Address { get; init; }

    /// <summary>What the machine costs; null for what its profile says.</summary>
    public JobRates? Rates { get; init; }

    /// <summary>The run that the page is about.</summary>
    public HistoryEntry? Run { get; init; }

    /// <summary>Its journal, beside which the trace was kept.</summary>
    public string? Journal { get; init; }

    /// <summary>Puts findings into the words of where they are read (<see cref="SettingWording"/>).</summary>
    public Func<Diagnostic, Diagnostic> Spell { get; init; } = SettingWording.OnConsole;

    /// <summary>The same about the run of <see cref="Journal"/>, or without one about the last run of the drawing that the history knows.</summary>
    public JobReportRequest WithRunOf(HistoryReading history)
    {
        ArgumentNullException.ThrowIfNull(history);
        var (drawing, journal) = (Path.GetFullPath(Drawing.FileName), Journal is null ? null : Path.GetFullPath(Journal));
        var run = history.Entries.FirstOrDefault(entry => entry.Drawing == drawing && (journal is null ? entry.Kind is "run" or "simulation" : entry.Journal == journal));
        var kept = run?.Journal is { } its && File.Exists(KeptTrace.PathOf(its)) ? its : null;
        return this with { Run = run, Journal = Journal ?? kept };
    }
}
