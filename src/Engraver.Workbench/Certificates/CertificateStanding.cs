using System.Globalization;
using Engraver.Core.Machines;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Files;
using Engraver.Workbench.Machines.Arming;

namespace Engraver.Workbench.Certificates;

/// <summary>Whether a certificate holds for a job as it is now.</summary>
public enum CertificateState
{
    /// <summary>There is none.</summary>
    None,

    /// <summary>Drawing, settings, profile and program are those that were read back.</summary>
    Stands,

    /// <summary>Something has changed since, or what is there cannot be read.</summary>
    Stale,
}

/// <summary>How a job stands to the certificate beside its drawing.</summary>
/// <param name="Differs">What has changed: <c>drawing</c>, <c>profile</c>, <c>target</c>, <c>program</c> and keys of settings; empty unless it is
/// stale.</param>
/// <param name="Certificate">Null where none can be read.</param>
public sealed record CertificateStanding(CertificateState State, IReadOnlyList<string> Differs, JobCertificate? Certificate)
{
    public static CertificateStanding None { get; } = new(CertificateState.None, [], null);

    /// <summary>Why the file is no certificate, without a full stop; null where it is one.</summary>
    public string? Problem { get; private init; }

    /// <summary>The job runs trajectories instead of the drawing; a certificate is of the drawing.</summary>
    private bool RunsTrajectories { get; init; }

    /// <summary>For people, without a full stop; settings and commands as their keys.</summary>
    public string Sentence => State switch
    {
        CertificateState.None when RunsTrajectories => Wording.Get("Certificate.Trajectories"),
        CertificateState.None => Wording.Get("Certificate.None"),
        CertificateState.Stands => Wording.Get("Certificate.Valid", Certificate!.MaxDeviation?.ToString("0.####", CultureInfo.InvariantCulture) ?? "?", Certificate.Issued.UtcDateTime),
        _ when Problem is { } problem => Wording.Get("Certificate.Unreadable", problem),
        _ => Wording.Get("Certificate.Stale", string.Join(", ", Differs.Select(Said))),
    };

    /// <summary>The line of the list before a start. A job runs without a certificate too; one that is of another job must have been read.</summary>
    public ArmingCheck Check => new(true, Sentence + ".") { IsWarning = State == CertificateState.Stale, IsNote = State == CertificateState.None };

    /// <summary>Of a job that a machine runs, by the certificate of what it is sent, at its usual place.</summary>
    /// <param name="program">Of the job, made fit for the link.</param>
    public static CertificateStanding OfRun(PreparedJob job, MotionProgram program)
    {
        ArgumentNullException.ThrowIfNull(job);
        if (FileKind.IsStream(job.Drawing.FileName)) return None;
        if (job.Followed is not null) return None with { RunsTrajectories = true };
        if (PostTable.ForMotion(MachineFamilies.DriverOf(program.Profile), program.Style) is not { } sent) return None;
        var path = CertificateFile.PathOf(job.Drawing.FileName, sent.Post.Name);
        return File.Exists(path) ? Of(path, JobIdentity.OfRun(job, program, sent.Post)) : None;
    }

    /// <summary>Of a job, by a certificate file.</summary>
    public static CertificateStanding Of(string path, JobIdentity job)
    {
        var (certificate, problem) = CertificateFile.Read(path);
        if (problem is not null) return new CertificateStanding(CertificateState.Stale, [], null) { Problem = problem };
        return certificate is null ? None : Of(certificate, job);
    }

    /// <summary>Of a job, by a certificate. The program is made only where everything else is the same.</summary>
    public static CertificateStanding Of(JobCertificate certificate, JobIdentity job)
    {
        ArgumentNullException.ThrowIfNull(certificate);
        ArgumentNullException.ThrowIfNull(job);
        var differs = job.Differences(certificate.Drawing.Sha256, certificate.Settings.Values, certificate.Profile.Sha256).ToList();
        if (certificate.Program.Target != job.Target || certificate.Program.Dialect != job.Dialect) differs.Add("target");
        if (differs.Count == 0 && (!certificate.Ok || job.Program.Value is null || certificate.Program.Sha256 != job.Program.Value)) differs.Add("program");
        return new CertificateStanding(differs.Count == 0 ? CertificateState.Stands : CertificateState.Stale, differs, certificate);
    }

    /// <summary>One of <see cref="Differs"/> for people; settings as their keys.</summary>
    internal static string Said(string part) => part switch
    {
        "drawing" or "profile" or "target" or "program" => Wording.Get("CertificateDiffers." + part),
        _ => $"[{part}]",
    };
}
