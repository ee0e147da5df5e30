using System.Text.Json;
using Engraver.Core.Languages;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Files;

namespace Engraver.Workbench.Certificates;

/// <summary>The file of a certificate: JSON beside the drawing, one for each target: <c>part.certificate.json</c> for the program that <c>part.dxf</c> is run
/// with, <c>part.agie.certificate.json</c> and similar names for other targets.</summary>
public static class CertificateFile
{
    public const string FileExtension = ".certificate.json";

    /// <summary>The default path.</summary>
    /// <param name="target">Name of the post.</param>
    /// <param name="dialect">The kind of controller; null for the default.</param>
    public static string PathOf(string drawing, string target, string? dialect = null) =>
        Path.ChangeExtension(drawing, null) + (target == PostTable.All[0].Post.Name ? "" : $".{target}") + (dialect is null ? "" : $"-{dialect}") + FileExtension;

    /// <summary>Writes the file atomically.</summary>
    /// <exception cref="IOException">The path cannot be written.</exception>
    /// <exception cref="UnauthorizedAccessException">The same.</exception>
    public static void Write(string path, JobCertificate certificate) => OutputFile.Write(path, output => output.WriteLine(Text(certificate)));

    /// <summary>The text of the file.</summary>
    public static string Text(JobCertificate certificate) => JsonSerializer.Serialize(certificate, CertificateJson.Default.JobCertificate);

    /// <summary>Reads it.</summary>
    /// <returns>The certificate, or why the file is invalid, without a full stop; neither if there is no file.</returns>
    public static (JobCertificate? Certificate, string? Problem) Read(string path)
    {
        if (!File.Exists(path) || FileKind.IsStream(path)) return (null, null);
        try
        {
            var read = JsonSerializer.Deserialize(File.ReadAllText(path), CertificateJson.Default.JobCertificate);
            if (read is null) return (null, Wording.Get("Certificate.IsJsonNull"));
            return read.Version == JobCertificate.CurrentVersion ? (read, null) : (null, Wording.Get("Certificate.OtherVersion", read.Version));
        }
        catch (Exception unusable) when (unusable is JsonException or IOException or UnauthorizedAccessException)
        {
            return (null, SystemErrorText.FromException(unusable));
        }
    }
}
