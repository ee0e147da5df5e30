using Engraver.Core.Machines;

namespace Engraver.Galil.Sessions;

/// <summary>Position and time at which the machine came to rest.</summary>
/// <param name="SegmentCounter">_CSS before the buffer was emptied: segments of the stopped sequence that were done.</param>
/// <param name="Position">_RP of the axes in the order of their letters, controller's counts.</param>
/// <param name="Time">TIME, samples.</param>
public sealed record StandstillReport(int SegmentCounter, CountsPoint Position, long Time)
{
    /// <summary>An output that the stop had switched off was seen on.</summary>
    public bool WasToolOn { get; init; }

    /// <summary>The output is still on.</summary>
    public bool IsToolOn { get; init; }
}
