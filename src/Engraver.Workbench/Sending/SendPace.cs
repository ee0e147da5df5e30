using Engraver.Core.Sending;

namespace Engraver.Workbench.Sending;

/// <summary>Rate and flow control of a transmission.</summary>
/// <param name="Frame">Frame of received characters.</param>
/// <param name="CharacterTime">Time of one character on the line.</param>
public sealed record SendPace(CharacterFrame Frame, TimeSpan CharacterTime)
{
    /// <summary>Additional delay after every character.</summary>
    public TimeSpan CharacterDelay { get; init; }

    /// <summary>Delay after every line.</summary>
    public TimeSpan LineDelay { get; init; }

    /// <summary>True to obey XOFF and XON.</summary>
    public bool ObeysXoff { get; init; } = true;

    /// <summary>Maximum duration of one pause by the receiver.</summary>
    public TimeSpan MaxPause { get; init; } = TimeSpan.FromSeconds(60);
}
