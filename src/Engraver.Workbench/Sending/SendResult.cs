namespace Engraver.Workbench.Sending;

/// <summary>Result of a transmission.</summary>
/// <param name="Lines">Lines of the program that were sent completely.</param>
/// <param name="Characters">All sent characters, including leader and line ends.</param>
/// <param name="Pauses">Number of received XOFF.</param>
/// <param name="ReceivedBytes">Received characters other than XON and XOFF.</param>
/// <param name="Reason">Why it failed, a sentence; null if it completed or was stopped.</param>
public sealed record SendResult(SendOutcome Outcome, int Lines, int TotalLines, long Characters, int Pauses, long ReceivedBytes, double Seconds, string? Reason);
