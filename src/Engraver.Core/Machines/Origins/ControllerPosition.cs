namespace Engraver.Core.Machines.Origins;

/// <summary>The machine's position as the controller reports it, and the values that show whether it still counts from the same zero as before.</summary>
/// <param name="Position">Counts from the controller's own zero.</param>
/// <param name="Serial">The controller's own serial number; null where it has none.</param>
/// <param name="Mark">The number that an earlier session stored in a variable of the controller, which loses it at power-off; null when there is none.</param>
/// <param name="Clock">The controller's own clock since power-on, in its ticks; null where it has none. A smaller number than before means that it was switched
/// off or reset.</param>
/// <param name="Doubt">Why the position may be wrong although the controller was not switched off ("the stepper motor of axis A is off"); empty for no
/// doubt.</param>
public sealed record ControllerPosition(CountsPoint Position, long? Serial = null, int? Mark = null, double? Clock = null, string Doubt = "")
{
    /// <summary>The controller's letters of the axes of <see cref="Position"/>, in its order.</summary>
    public string Letters { get; init; } = "";

    /// <summary>The letters of those axes whose position is lost when their motor is off, because no encoder counts how they are moved then.</summary>
    public string WithoutEncoder { get; init; } = "";

    /// <summary>The letters of those of <see cref="WithoutEncoder"/> whose last motion was stopped without a ramp: they may have lost steps then. The
    /// controller
    /// does not report whether that was before an origin was set.</summary>
    public string StoppedWithoutRamp { get; init; } = "";

    /// <summary>The letters of those of them that are assumed to be steppers because neither the controller nor the profile states their motor type.</summary>
    public string AssumedSteppers { get; init; } = "";
}
