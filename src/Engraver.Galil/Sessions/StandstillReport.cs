namespace Engraver.Galil.Sessions;

/// <summary>Where and when the machine came to rest.</summary>
/// <param name="SegmentCounter">_CSS before the buffer was emptied: segments of the stopped sequence that were done.</param>
/// <param name="X">_RPA, controller's counts.</param>
/// <param name="Time">TIME, samples.</param>
public sealed record StandstillReport(int SegmentCounter, int X, int Y, long Time);
