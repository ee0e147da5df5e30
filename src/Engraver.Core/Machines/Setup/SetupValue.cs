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
