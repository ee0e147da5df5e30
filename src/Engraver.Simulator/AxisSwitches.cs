namespace Engraver.Simulator;

/// <summary>Positions of the switches and the index pulse of one axis, in counts from where the axis is at power up; DP does not move them.</summary>
/// <param name="Axis">0 to 3 for A to D.</param>
public sealed record AxisSwitches(int Axis)
{
    /// <summary>The forward limit switch is active at this position and above it; null when there is none.</summary>
    public int? ForwardLimitAt { get; init; }

    /// <summary>The reverse limit switch is active at this position and below it; null when there is none.</summary>
    public int? ReverseLimitAt { get; init; }

    /// <summary>The home switch is active at this position and above it, or below it (<see cref="IsHomeBelow"/>); null when there is none.</summary>
    public int? HomeAt { get; init; }

    /// <summary>The home switch is active at <see cref="HomeAt"/> and below it.</summary>
    public bool IsHomeBelow { get; init; }

    /// <summary>How far the home switch reaches, counts from <see cref="HomeAt"/>: behind that it is not active any more.</summary>
    public int HomeReach { get; init; } = int.MaxValue;

    /// <summary>The home switch opens its input while it is active, whatever the limit switches do.</summary>
    public bool IsHomeNormallyClosed { get; init; }

    /// <summary>Position of one index pulse of the encoder; the others follow every <see cref="IndexPeriod"/> counts.</summary>
    public int IndexAt { get; init; }

    /// <summary>Counts from one index pulse to the next.</summary>
    public int IndexPeriod { get; init; } = 4000;

    /// <summary>An active switch opens its input instead of grounding it, as switches for CN 1 do (galil-dmc.md C.1).</summary>
    public bool AreNormallyClosed { get; init; }
}
