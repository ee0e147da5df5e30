using Engraver.Workbench.Certificates;

namespace Engraver.Cli.Output.Jobs;

/// <summary>What <c>engraver certify --check --json</c> prints; names and meanings are the runner's contract.</summary>
/// <param name="Standing">One of the words <c>stands</c>, <c>none</c> and <c>stale</c>.</param>
/// <param name="Differs">drawing, profile, fonts, target, program and keys of settings.</param>
/// <param name="Problem">Why the file is not a valid certificate; null when it is valid or missing.</param>
internal sealed record CertificateCheckJson(string Standing, string File, IReadOnlyList<string> Differs, string? Problem)
{
    public static CertificateCheckJson From(CertificateStatus standing, string file) =>
        new(standing.State switch { CertificateState.Stands => "stands", CertificateState.None => "none", _ => "stale" }, file, standing.Differences, standing.Problem);
}
