using System.Globalization;
using Engraver.Core.Machines;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Files;
using Engraver.Workbench.LetteredDrawings;
using Engraver.Workbench.Machines.Arming;

namespace Engraver.Workbench.Certificates;

/// <summary>The status of the certificate beside a job's drawing.</summary>
/// <param name="Differences">What has changed: <c>drawing</c>, <c>profile</c>, <c>fonts</c>, <c>target</c>, <c>program</c> and keys of settings; empty
/// unless it is stale.</param>
/// <param name="Certificate">Null when none can be read.</param>
public sealed record CertificateStatus(CertificateState State, IReadOnlyList<string> Differences, JobCertificate? Certificate)
{
    public static CertificateStatus None { get; } = new(CertificateState.None, [], null);

    /// <summary>Why the file is not a valid certificate, without a full stop; null when it is.</summary>
    public string? Problem { get; private init; }

    /// <summary>Names of the fonts whose files, or whose substitutes, are not those of the certificate.</summary>
    public IReadOnlyList<string> ChangedFonts { get; private init; } = [];

    /// <summary>The job runs trajectories instead of the drawing; a certificate covers the drawing only.</summary>
    private bool RunsTrajectories { get; init; }

    /// <summary>The displayed sentence without a full stop; settings and commands are named by their keys.</summary>
    public string Message => State switch
    {
        CertificateState.None when RunsTrajectories => Wording.Get("Certificate.Trajectories"),
        CertificateState.None => Wording.Get("Certificate.None"),
        CertificateState.Stands => Wording.Get("Certificate.Valid", Certificate!.MaxDeviation?.ToString("0.####", CultureInfo.InvariantCulture) ?? "?", Certificate.Issued.UtcDateTime),
        _ when Problem is { } problem => Wording.Get("Certificate.Unreadable", problem),
        _ => Wording.Get("Certificate.Stale", string.Join(", ", Differences.Select(part => part == "fonts" && ChangedFonts.Count > 0 ? Wording.Get("CertificateDiffers.fontsNamed", string.Join(", ", ChangedFonts)) : PartName(part)))),
    };

    /// <summary>The start check. A job runs without a certificate too; a stale certificate must be acknowledged.</summary>
    public ArmingCheck Check => new(true, Message + ".") { IsWarning = State == CertificateState.Stale, IsNote = State == CertificateState.None };

    /// <summary>Status for a job that a machine runs, from the certificate of the sent program at its default path.</summary>
    /// <param name="program">The job's program with feeds limited to the link.</param>
    public static CertificateStatus OfRun(PreparedJob job, MotionProgram program)
    {
        ArgumentNullException.ThrowIfNull(job);
        if (FileKind.IsStream(job.Drawing.FileName)) return None;
        if (job.Trajectories is not null) return None with { RunsTrajectories = true };
        if (PostTable.ForMotion(MachineFamilies.DriverOf(program.Profile), program.Style) is not { } sent) return None;
        var path = CertificateFile.PathOf(job.Drawing.FileName, sent.Post.Name);
        return File.Exists(path) ? Of(path, JobIdentity.OfRun(job, program, sent.Post)) : None;
    }

    /// <summary>Status for a job from a certificate file.</summary>
    public static CertificateStatus Of(string path, JobIdentity job)
    {
        var (certificate, problem) = CertificateFile.Read(path);
        if (problem is not null) return new CertificateStatus(CertificateState.Stale, [], null) { Problem = problem };
        return certificate is null ? None : Of(certificate, job);
    }

    /// <summary>Status for a job from a certificate. The program is generated only if everything else matches.</summary>
    public static CertificateStatus Of(JobCertificate certificate, JobIdentity job)
    {
        ArgumentNullException.ThrowIfNull(certificate);
        ArgumentNullException.ThrowIfNull(job);
        var differs = job.Differences(certificate.Drawing.Sha256, certificate.Settings.Values, certificate.Profile.Sha256, certificate.Fonts).ToList();
        if (certificate.Program.Target != job.Target || certificate.Program.Dialect != job.Dialect) differs.Add("target");
        if (differs.Count == 0 && (!certificate.Ok || job.Program.Value is null || certificate.Program.Sha256 != job.Program.Value)) differs.Add("program");
        return new CertificateStatus(differs.Count == 0 ? CertificateState.Stands : CertificateState.Stale, differs, certificate) { ChangedFonts = differs.Contains("fonts") ? CutFont.Differences(certificate.Fonts, job.Fonts) : [] };
    }

    /// <summary>One of <see cref="Differences"/> as displayed; settings by their keys.</summary>
    internal static string PartName(string part) => part switch
    {
        "drawing" or "profile" or "fonts" or "target" or "program" => Wording.Get("CertificateDiffers." + part),
        _ => $"[{part}]",
    };
}
