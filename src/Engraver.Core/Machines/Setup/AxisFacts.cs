namespace Engraver.Core.Machines.Setup;

/// <summary>The controller's settings and state of one axis.</summary>
/// <param name="Letter">The controller's letter of the axis.</param>
/// <param name="Motor">The signal that it sends to the drive.</param>
/// <param name="Encoder">How it reads the encoder.</param>
/// <param name="ErrorLimit">Following error beyond which the controller reports an error, counts; 0 or less: never.</param>
/// <param name="OffOnError">The controller switches the motor off beyond that limit.</param>
/// <param name="Position">Commanded position, counts.</param>
/// <param name="Error">Following error, counts.</param>
public sealed record AxisFacts(char Letter, MotorType? Motor, EncoderType? Encoder, int? ErrorLimit, bool? OffOnError, int Position, int Error)
{
    public bool IsMotorOff { get; init; }

    /// <summary>The limit switch in the direction of increasing counts is active, by the present sense.</summary>
    public bool? ForwardHit { get; init; }

    /// <summary>The limit switch in the direction of decreasing counts is active, by the present sense.</summary>
    public bool? ReverseHit { get; init; }

    /// <summary>The home input, by the present sense.</summary>
    public bool? Home { get; init; }
}
