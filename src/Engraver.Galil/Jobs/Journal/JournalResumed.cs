using System.Text;
using System.Text.Json;
using System.Text.Json.Serialization;
using Engraver.Core.Machines;
using Engraver.Galil.Language;
using Engraver.Galil.Sessions;

namespace Engraver.Galil.Jobs.Journal;

/// <summary>A later job has resumed this one, and has its own journal.</summary>
/// <param name="By">Path of that journal.</param>
public sealed record JournalResumed(string By)
{
    public string Kind { get; } = "resumed";
}
