using Engraver.Galil.Language;
using Engraver.TestKit;
using Engraver.Workbench.Certificates;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Files;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Tests.Certificates;

/// <summary>A copy of a sample in a temporary folder, with the settings to certify and run it.</summary>
internal sealed class CertifiedPart : IDisposable
{
    private readonly DirectoryInfo _folder = Directory.CreateTempSubdirectory("engraver-certificate-");

    public CertifiedPart(string sample = "paper-001")
    {
        File = Path.Combine(_folder.FullName, "part.dxf");
        System.IO.File.Copy(Path.Combine(RepositoryFolder.Samples, sample + ".dxf"), File);
    }

    public static DateTimeOffset Now { get; } = new(2026, 11, 23, 9, 0, 0, TimeSpan.Zero);

    public string File { get; }

    public DrawingSettings Settings { get; init; } = new();

    public string Certificate => CertificateFile.PathOf(File, "galil");

    public CertificationRequest Request(string target = "galil") => new(DrawingFile.Open(File, Settings, CancellationToken.None), ContentHash.OfFile(File), Settings, PostTable.Find(target), Now);

    /// <summary>Certifies the current part and saves the certificate.</summary>
    public async Task<JobCertificate> CertifyAsync(CertificationRequest? request = null)
    {
        var made = (await Certification.CertifyAsync(request ?? Request(), null, CancellationToken.None)).Certificate!;
        CertificateFile.Write(CertificateFile.PathOf(File, made.Program.Target, made.Program.Dialect), made);
        return made;
    }

    /// <summary>Certificate status of a run of the part, optionally with other settings.</summary>
    public CertificateStatus Standing(JobMode mode = JobMode.Stream, DrawingSettings? settings = null)
    {
        var job = JobPreparation.Prepare(DrawingFile.Open(File, settings ?? Settings, CancellationToken.None), settings ?? Settings, mode.Strategy().Style);
        return CertificateStatus.OfRun(job, job.Motion.Program!);
    }

    public void Dispose() => _folder.Delete(recursive: true);
}
