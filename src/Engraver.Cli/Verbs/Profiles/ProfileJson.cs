using System.Text.Json.Serialization;
using Engraver.Cli.Output;
using Engraver.Core.Machines.Profiles;

namespace Engraver.Cli.Verbs.Profiles;

/// <summary>What <c>engraver profile check --json</c> prints; names and meanings are the runner's contract.</summary>
/// <param name="Ok">Whether a job can run with it; warnings do not prevent that.</param>
/// <param name="Findings">Findings in the order of the check.</param>
/// <param name="Meaning">Sentences; empty when the profile cannot be used.</param>
internal sealed record ProfileJson(string File, bool Ok, IReadOnlyList<DiagnosticJson> Findings, IReadOnlyList<string> Meaning)
{
    public static ProfileJson From(string file, MachineProfileReadResult read, IReadOnlyList<string> meaning) => new(file, read.Profile is not null, [.. read.Diagnostics.Select(DiagnosticJson.From)], meaning);
}

[JsonSourceGenerationOptions(PropertyNamingPolicy = JsonKnownNamingPolicy.CamelCase, WriteIndented = true, NewLine = "\n", GenerationMode = JsonSourceGenerationMode.Metadata)]
[JsonSerializable(typeof(ProfileJson))]
internal sealed partial class ProfileContract : JsonSerializerContext;
