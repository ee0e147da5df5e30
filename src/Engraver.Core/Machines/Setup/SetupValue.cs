namespace Engraver.Core.Machines.Setup;

/// <summary>One value of the controller's settings for its wiring.</summary>
public abstract record SetupValue
{
    private SetupValue()
    {
    }

    /// <summary>Set only with the motor off.</summary>
    public sealed record Motor(char Axis, MotorType Type) : SetupValue;

    /// <summary>Set only with the motor off: a servo whose encoder is reversed while it is on runs away.</summary>
    public sealed record Encoder(char Axis, EncoderType Type) : SetupValue;

    /// <param name="Counts">At least 1.</param>
    public sealed record ErrorLimit(char Axis, int Counts) : SetupValue;

    public sealed record OffOnError(char Axis, bool IsOn) : SetupValue;

    /// <summary>For every axis.</summary>
    public sealed record LimitSense(SwitchSense Sense) : SetupValue;

    /// <summary>For every axis.</summary>
    public sealed record HomeSense(SwitchSense Sense) : SetupValue;
}

/// <summary>The signal sent to the drive of an axis.</summary>
/// <param name="IsReversed">The other sense of rotation.</param>
public readonly record struct MotorType(MotorSignal Signal, bool IsReversed);

public enum MotorSignal
{
    /// <summary>A voltage, from the error of the position loop.</summary>
    Servo,

    /// <summary>Pulses and direction, the pulse being the low level.</summary>
    LowPulses,

    /// <summary>Pulses and direction, the pulse being the high level.</summary>
    HighPulses,
}

/// <summary>How an encoder is read.</summary>
/// <param name="IsReversed">Counts decrease where they would increase.</param>
public readonly record struct EncoderType(EncoderSignal Signal, bool IsReversed);

public enum EncoderSignal
{
    Quadrature,
    PulseAndDirection,
}

/// <summary>The level of an input that counts as active.</summary>
public enum SwitchSense
{
    /// <summary>A switch closed to ground, the factory default of a controller.</summary>
    Low,

    /// <summary>An open switch: normally closed switches, where a broken wire is detected.</summary>
    High,
}
