using Engraver.Galil.Sessions;

namespace Engraver.Galil.Jobs;

/// <summary>The controller as a job found it, written before anything in it is changed: if this program dies, the next run gives it back (<see cref="EarlierRun"/>).</summary>
/// <param name="Address">Where the controller was reached.</param>
/// <param name="Controller">Its model string.</param>
/// <param name="SerialNumber">_BN; null where the controller cannot say.</param>
/// <param name="State">Settings; the program memory lies beside the journal.</param>
public sealed record JournalFound(string Address, string Controller, double? SerialNumber, FoundState State)
{
    public string Kind { get; } = "found";

    /// <summary>True when both tell of the same controller.</summary>
    internal bool IsSameController(JournalFound other) => (Address, Controller, SerialNumber) == (other.Address, other.Controller, other.SerialNumber);
}
