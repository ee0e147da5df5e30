namespace Engraver.Core.Machines.Setup;

public enum MotorSignal
{
    /// <summary>A voltage, from the error of the position loop.</summary>
    Servo,

    /// <summary>Pulses and direction, the pulse being the low level.</summary>
    LowPulses,

    /// <summary>Pulses and direction, the pulse being the high level.</summary>
    HighPulses,
}
