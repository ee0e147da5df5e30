namespace Engraver.Core.Machines;

/// <summary>The state of an idle controller at one time, in counts. Null for values that it does not report.</summary>
/// <param name="Position">Of the axes that a job moves, from the controller's own zero.</param>
/// <param name="Error">Following error of each axis: commanded minus actual position.</param>
/// <param name="IsMoving">An axis or the path is in motion.</param>
/// <param name="MotorsOff">The controller's letters of the axes whose motor is off; empty for none.</param>
public sealed record MachineReading(CountsPoint Position, CountsPoint Error, bool IsMoving, string MotorsOff)
{
    public long X => Position.X;

    public long Y => Position.Y;

    /// <summary>Inputs 1 to 8, bit 0 is input 1.</summary>
    public int? Inputs { get; init; }

    /// <summary>Outputs 1 to 8, bit 0 is output 1.</summary>
    public int? Outputs { get; init; }

    /// <summary>Speed along the path, counts/s.</summary>
    public double? Speed { get; init; }

    /// <summary>The limits that are active, in words; empty for none.</summary>
    public string Limit { get; init; } = "";

    /// <summary>The controller's letters of the axes that were switched off because of their position error.</summary>
    public string LostPosition { get; init; } = "";

    /// <summary>The controller's letters of the axes whose last motion was stopped without a ramp.</summary>
    public string StoppedWithoutRamp { get; init; } = "";

    /// <summary>The abort input is active.</summary>
    public bool AbortInput { get; init; }

    /// <summary>The controller runs a program, which this program did not start while the machine is only monitored.</summary>
    public bool IsProgramRunning { get; init; }

    /// <summary>True when a value on which arming depends was changed, by a person or a program.</summary>
    public bool DiffersFrom(MachineReading other)
    {
        ArgumentNullException.ThrowIfNull(other);
        return (Position, IsMoving, MotorsOff, Limit, AbortInput, IsProgramRunning, Inputs) != (other.Position, other.IsMoving, other.MotorsOff, other.Limit, other.AbortInput, other.IsProgramRunning, other.Inputs);
    }
}
