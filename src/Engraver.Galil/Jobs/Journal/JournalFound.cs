using Engraver.Galil.Sessions;

namespace Engraver.Galil.Jobs.Journal;

/// <summary>The controller's state before a job, written before anything in it is changed: if this program fails, the next run restores it
/// (<see cref="CrashRecovery"/>).</summary>
/// <param name="Address">The controller's address.</param>
/// <param name="Controller">Its model string.</param>
/// <param name="SerialNumber">_BN; null where the controller does not report it.</param>
/// <param name="State">Settings; the program memory is in a file beside the journal.</param>
public sealed record JournalFound(string Address, string Controller, double? SerialNumber, FoundState State)
{
    public string Kind { get; } = "found";

    /// <summary>True when both describe the same controller.</summary>
    internal bool IsSameController(JournalFound other) => (Address, Controller, SerialNumber) == (other.Address, other.Controller, other.SerialNumber);
}
