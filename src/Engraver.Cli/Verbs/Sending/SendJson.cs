using System.Text.Json.Serialization;
using Engraver.Cli.Output;
using Engraver.Workbench.Sending;

namespace Engraver.Cli.Verbs.Sending;

/// <summary>What <c>engraver send --json</c> prints; names and meanings are the runner's contract.</summary>
/// <param name="Outcome">complete, stopped, linkLost or heldTooLong.</param>
/// <param name="Lines">Lines of the program that were sent completely.</param>
/// <param name="Characters">All characters sent.</param>
/// <param name="Holds">Number of received XOFF.</param>
/// <param name="Heard">Received characters other than XON and XOFF.</param>
internal sealed record SendJson(string Outcome, int Lines, int OfLines, long Characters, int Holds, long Heard, double Seconds, string? Reason)
{
    public static SendJson From(SendResult result) => new(Word(result.Outcome), result.Lines, result.TotalLines, result.Characters, result.Pauses, result.ReceivedBytes, result.Seconds, result.Reason);

    private static string Word(SendOutcome outcome) => outcome switch { SendOutcome.Complete => "complete", SendOutcome.Stopped => "stopped", SendOutcome.LinkLost => "linkLost", _ => "heldTooLong" };
}

/// <summary>What <c>engraver receive --json</c> prints.</summary>
/// <param name="Outcome">complete, stopped, silent or linkLost.</param>
/// <param name="File">The written file; null if none.</param>
/// <param name="Damaged">Characters with a parity error.</param>
/// <param name="Findings">The parity errors.</param>
internal sealed record ReceiveJson(string Outcome, string? File, int Lines, int Characters, int Damaged, IReadOnlyList<DiagnosticJson> Findings);

[JsonSourceGenerationOptions(PropertyNamingPolicy = JsonKnownNamingPolicy.CamelCase, WriteIndented = true, NewLine = "\n", GenerationMode = JsonSourceGenerationMode.Metadata)]
[JsonSerializable(typeof(SendJson))]
[JsonSerializable(typeof(ReceiveJson))]
internal sealed partial class SendContract : JsonSerializerContext;
