using Engraver.Core.Diagnostics;
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

/// <summary>The data of a job report: the job, its plan and cost, its certificate, and its run if any.</summary>
/// <param name="Job">Prepared in the style of <paramref name="Strategy"/>.</param>
/// <param name="Certificate">Status of the certificate beside its drawing.</param>
/// <param name="Now">Date of the report.</param>
public sealed record JobReport(PreparedJob Job, ExecutionStrategy Strategy, CertificateStatus Certificate, DateTimeOffset Now)
{
    /// <summary>The motion program with feeds limited to the link; null if nothing can be cut.</summary>
    public MotionProgram? Program { get; private init; }

    /// <summary>The planned times of the program, over the link.</summary>
    public MotionTimes Times { get; private init; }

    /// <summary>Null if machine rates are undefined.</summary>
    public JobCost? Cost { get; private init; }

    /// <summary>The parts of the job; null without operations, and if nothing can be cut.</summary>
    public JobShares? Shares { get; private init; }

    /// <summary>The planned motion over time; null if nothing can be cut.</summary>
    public PlannedMotion? Motion { get; private init; }

    /// <summary>Findings of every stage, errors first, named for the front end.</summary>
    public IReadOnlyList<Diagnostic> Findings { get; private init; } = [];

    /// <summary>Status of the certificates of other targets beside its drawing, by target and dialect.</summary>
    public IReadOnlyList<(string Target, CertificateStatus Standing)> OtherCertificates { get; private init; } = [];

    /// <summary>The reported run; null for a job that was not run or has no history entry.</summary>
    public HistoryEntry? Run { get; private init; }

    /// <summary>The run from its journal if it has no history entry; otherwise null.</summary>
    public JournalledRun? Journalled { get; private init; }

    /// <summary>The file of <see cref="Journalled"/>, and whether its job is the reported one.</summary>
    public (string File, bool IsThisJob) Journal { get; private init; }

    /// <summary>Changes since that run, as in a certificate; empty if there are none or there is no run.</summary>
    public IReadOnlyList<string> RunDifferences { get; private init; } = [];

    /// <summary>The trace of that run; null if it was not saved.</summary>
    public RunTrace? Trace { get; private init; }

    /// <summary>Why a saved trace cannot be shown; null if it can or there is none.</summary>
    public string? TraceProblem { get; private init; }

    /// <summary>Collects the data. The texts of a plate have the values of the reported run.</summary>
    /// <exception cref="SettingException">A named layer or the entry entity is not in the drawing.</exception>
    /// <exception cref="OperationCanceledException">The caller cancelled.</exception>
    public static JobReport Create(JobReportRequest request, CancellationToken cancellation)
    {
        ArgumentNullException.ThrowIfNull(request);
        var plate = (request.Journal ?? request.Run?.Journal) is { } its ? JournalPlate.Read(its) ?? request.Plate : request.Plate;
        var job = PlateJob.Prepare(request.Drawing, request.Settings, request.Strategy.Style, plate, cancellation);
        var fit = job.Motion.Program is { } planned ? JobPlan.FitToLink(planned, request.Address, request.Strategy, job.Drawing) : null;
        var program = fit?.Program;
        var sheet = program is null ? null : JobSheet.Of(job, program, JobPlan.StrokeTimes(program, request.Address, request.Strategy), request.Rates ?? request.Settings.Machine.Rates);
        var standing = program is null ? CertificateStatus.None : CertificateStatus.OfRun(job, program);
        cancellation.ThrowIfCancellationRequested();
        var report = new JobReport(job, request.Strategy, standing, request.Now)
        {
            Program = program,
            Times = sheet?.Times ?? default,
            Cost = sheet?.Cost,
            Shares = sheet?.Shares,
            Motion = program is { SegmentCount: > 0 } ? PlannedMotion.Create(program, job.Toolpath, MachineFamilies.DriverOf(program.Profile).NetworkTimes, null, cancellation) : null,
            Findings = [.. job.Diagnostics.Concat(fit?.Diagnostics ?? []).OrderByDescending(found => found.Severity).Select(request.Spell)],
            OtherCertificates = [.. OthersOf(request, request.Strategy.Style, cancellation)],
            Run = request.Run,
            RunDifferences = request.Run is { } run ? JobIdentity.Of(request.Drawing, request.Settings, "", () => null).Differences(run.DrawingSha256, run.Settings, run.ProfileHash(request.Families), run.Fonts ?? []) : [],
        };
        if (request.Journal is not { } journal) return report;
        report = report.WithTrace(journal);
        return request.Run is null && JournalledRun.Read(journal) is { } told ? report with { Journalled = told, Journal = (Path.GetFullPath(journal), IsOf(told, program, job)) } : report;
    }

    /// <summary>Whether the journal belongs to the job; a run in the other style has different segments.</summary>
    private static bool IsOf(JournalledRun told, MotionProgram? program, PreparedJob job)
    {
        if (told.Program.Length == 0) return true;
        if (program is not null && ProgramFingerprint.Of(program) == told.Program) return true;
        return told.Strategy.Style != program?.Style && JobPreparation.Prepare(job.Drawing, job.Settings, told.Strategy.Style).Motion.Program is { } other && ProgramFingerprint.Of(other) == told.Program;
    }

    private static IEnumerable<(string, CertificateStatus)> OthersOf(JobReportRequest request, MotionStyle sent, CancellationToken cancellation)
    {
        var hash = new Lazy<string?>(() => ContentHash.OfFile(request.Drawing.FileName));
        foreach (var (entry, dialect) in PostTable.All.Where(entry => entry.Reader is not null && entry.Post.Motion != sent).SelectMany(entry => entry.Dialects.Keys.Cast<string?>().Prepend(null), (entry, dialect) => (entry, dialect)))
        {
            cancellation.ThrowIfCancellationRequested();
            var path = CertificateFile.PathOf(request.Drawing.FileName, entry.Post.Name, dialect);
            if (!File.Exists(path)) continue;
            var job = new CertificationRequest(request.Drawing, hash.Value, request.Settings, entry, request.Now) { Dialect = dialect, Address = request.Address, Strategy = request.Strategy };
            yield return ($"{entry.Post.Name} {dialect}".TrimEnd(), CertificateStatus.Of(path, Certification.IdentityOf(job)));
        }
    }

    private JobReport WithTrace(string journal)
    {
        try
        {
            var trace = TraceFile.Read(journal);
            return trace.CanBeOf(DrawnFingerprint.Of(Job.Analysed.ToSegments())) ? this with { Trace = trace } : this with { TraceProblem = Wording.Get("Trace.OtherDrawing", Path.GetFileName(Job.Drawing.FileName)) };
        }
        catch (Exception unreadable) when (unreadable is IOException or UnauthorizedAccessException or FormatException)
        {
            return this with { TraceProblem = SystemErrorText.FromException(unreadable) };
        }
    }
}
