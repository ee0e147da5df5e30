namespace Engraver.Core.Posts;

/// <summary>What the operation of a stroke requires of a program.</summary>
/// <param name="Feed">Along the path, mm/min.</param>
/// <param name="Plunge">Straight down, mm/min; null without a tool axis.</param>
/// <param name="Spindle">Turns per minute; null: that of the post.</param>
/// <param name="Power">Of a beam, percent of its full power; null: not stated.</param>
/// <param name="Overscan">Way of a beam that is off before and behind each line, mm; 0 for none.</param>
/// <param name="Tool">Number of the tool.</param>
/// <param name="PierceSeconds">Wait before the first move.</param>
/// <param name="DwellSeconds">Wait after the last move.</param>
public sealed record StrokeRequirement(double Feed, double? Plunge, double? Spindle, double? Power, double Overscan, int Tool, double PierceSeconds, double DwellSeconds)
{
    /// <summary>Outputs that are on besides tool and spindle; bit 0 is output 1.</summary>
    public int Outputs { get; init; }
}
