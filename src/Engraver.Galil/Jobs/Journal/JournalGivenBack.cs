using System.Text;
using System.Text.Json;
using System.Text.Json.Serialization;
using Engraver.Core.Machines;
using Engraver.Galil.Language;
using Engraver.Galil.Sessions;

namespace Engraver.Galil.Jobs.Journal;

/// <summary>A later run has restored the controller after the one that failed.</summary>
/// <param name="By">Journal of the later run.</param>
public sealed record JournalGivenBack(string By)
{
    public string Kind { get; } = "givenBack";
}
