using Engraver.Core.Machines.Moves;

namespace Engraver.Core.Machines;

/// <summary>One axis of the controller.</summary>
/// <param name="Letter">The controller's letter of the axis.</param>
/// <param name="CountsPerMillimetre">Quadrature counts or steps; negative mirrors the axis of the drawing.</param>
/// <param name="MotorType">The controller's number of the type (galil-dmc.md C, MT: 1 servo, 2 stepper); null leaves it unchanged.</param>
public readonly record struct MachineAxis(char Letter, double CountsPerMillimetre, double? MotorType = null)
{
    /// <summary>Converts between its counts and millimetres.</summary>
    public AxisScale Scale => new(CountsPerMillimetre);

    /// <summary>The profile makes it a stepper (galil-dmc.md C, MT: 2, -2, 2.5 or -2.5), whose motion no encoder counts.</summary>
    public bool IsStepper => MotorType is { } type && Math.Abs(type) >= 2.0;

    /// <summary>Its travel, machine mm; null where the profile does not state it.</summary>
    public AxisTravel? Travel { get; init; }

    /// <summary>How it is homed; null where it is not homed.</summary>
    public AxisHoming? Homing { get; init; }
}
