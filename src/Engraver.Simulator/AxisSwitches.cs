namespace Engraver.Simulator;

/// <summary>Where the switches and the index pulse of one axis lie, in counts from the place where the axis stands at power up; DP does not move them.</summary>
/// <param name="Axis">0 to 3 for A to D.</param>
public sealed record AxisSwitches(int Axis)
{
    /// <summary>From here on upwards the forward limit switch is pressed; null when there is none.</summary>
    public int? ForwardLimitAt { get; init; }

    /// <summary>From here on downwards the reverse limit switch is pressed; null when there is none.</summary>
    public int? ReverseLimitAt { get; init; }

    /// <summary>From here on upwards the home switch is pressed; null when there is none.</summary>
    public int? HomeAt { get; init; }

    /// <summary>A place of the encoder's index pulse.</summary>
    public int IndexAt { get; init; }

    /// <summary>Counts from one index pulse to the next.</summary>
    public int IndexPeriod { get; init; } = 4000;

    /// <summary>A pressed switch opens its input instead of grounding it, as switches for CN 1 do (galil-dmc.md C.1).</summary>
    public bool AreNormallyClosed { get; init; }
}
