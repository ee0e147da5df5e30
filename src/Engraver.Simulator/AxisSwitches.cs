namespace Engraver.Simulator;

/// <summary>Positions of the switches and the index pulse of one axis, in counts from the axis position at power up; DP does not move them.</summary>
/// <param name="Axis">0 to 3 for A to D.</param>
public sealed record AxisSwitches(int Axis)
{
    /// <summary>The forward limit switch is active at and above this position; null when there is none.</summary>
    public int? ForwardLimitAt { get; init; }

    /// <summary>The reverse limit switch is active at and below this position; null when there is none.</summary>
    public int? ReverseLimitAt { get; init; }

    /// <summary>The home switch is active at and above this position, or at and below it (<see cref="IsHomeBelow"/>); null when there is none.</summary>
    public int? HomeAt { get; init; }

    /// <summary>The home switch is active at and below <see cref="HomeAt"/>.</summary>
    public bool IsHomeBelow { get; init; }

    /// <summary>Width of the active range of the home switch, counts from <see cref="HomeAt"/>; the switch is inactive beyond it.</summary>
    public int HomeReach { get; init; } = int.MaxValue;

    /// <summary>The home switch opens its input while it is active, independently of the type of the limit switches.</summary>
    public bool IsHomeNormallyClosed { get; init; }

    /// <summary>Position of one index pulse of the encoder; the others follow every <see cref="IndexPeriod"/> counts.</summary>
    public int IndexAt { get; init; }

    /// <summary>Counts from one index pulse to the next.</summary>
    public int IndexPeriod { get; init; } = 4000;

    /// <summary>An active switch opens its input instead of grounding it, as switches for CN 1 do (galil-dmc.md C.1).</summary>
    public bool AreNormallyClosed { get; init; }
}
