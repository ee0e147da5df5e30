using Engraver.Workbench.Certificates;

namespace Engraver.Cli.Output.Jobs;

/// <summary>What <c>engraver certify --check --json</c> prints; names and meanings are the runner's contract.</summary>
/// <param name="Standing">stands, none or stale.</param>
/// <param name="Differs">drawing, profile, target, program and keys of settings.</param>
/// <param name="Problem">Why the file is no certificate; null where it is one, or where there is none.</param>
internal sealed record CertificateCheckJson(string Standing, string File, IReadOnlyList<string> Differs, string? Problem)
{
    public static CertificateCheckJson From(CertificateStanding standing, string file) =>
        new(standing.State switch { CertificateState.Stands => "stands", CertificateState.None => "none", _ => "stale" }, file, standing.Differs, standing.Problem);
}
