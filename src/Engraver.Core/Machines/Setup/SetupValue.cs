namespace Engraver.Core.Machines.Setup;

/// <summary>One value that a controller is told of its wiring.</summary>
public abstract record SetupValue
{
    private SetupValue()
    {
    }

    /// <summary>Only with the motor off.</summary>
    public sealed record Motor(char Axis, MotorType Type) : SetupValue;

    /// <summary>Only with the motor off: a servo whose encoder is reversed under current runs away.</summary>
    public sealed record Encoder(char Axis, EncoderType Type) : SetupValue;

    /// <param name="Counts">At least 1.</param>
    public sealed record ErrorLimit(char Axis, int Counts) : SetupValue;

    public sealed record OffOnError(char Axis, bool IsOn) : SetupValue;

    /// <summary>Of every axis.</summary>
    public sealed record LimitSense(SwitchSense Sense) : SetupValue;

    /// <summary>Of every axis.</summary>
    public sealed record HomeSense(SwitchSense Sense) : SetupValue;
}

/// <summary>What is sent to the drive of an axis.</summary>
/// <param name="IsReversed">The other sense of rotation.</param>
public readonly record struct MotorType(MotorSignal Signal, bool IsReversed);

public enum MotorSignal
{
    /// <summary>A voltage, by the error of the position loop.</summary>
    Servo,

    /// <summary>Pulses and direction, the pulse being the low level.</summary>
    LowPulses,

    /// <summary>Pulses and direction, the pulse being the high level.</summary>
    HighPulses,
}

/// <summary>How an encoder is read.</summary>
/// <param name="IsReversed">Counts fall where they would rise.</param>
public readonly record struct EncoderType(EncoderSignal Signal, bool IsReversed);

public enum EncoderSignal
{
    Quadrature,
    PulseAndDirection,
}

/// <summary>The level of an input that counts as active.</summary>
public enum SwitchSense
{
    /// <summary>A closed switch to ground, the usual state of a controller from the factory.</summary>
    Low,

    /// <summary>An open one: normally closed switches, whose broken wire is noticed.</summary>
    High,
}
