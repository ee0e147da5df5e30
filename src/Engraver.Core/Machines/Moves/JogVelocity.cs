namespace Engraver.Core.Machines.Moves;

/// <summary>Speed of each axis in a jog, mm/min of the drawing's axes; positive in the positive direction of the drawing.</summary>
/// <param name="X">Along the drawing's X.</param>
/// <param name="Y">Along the drawing's Y.</param>
/// <param name="Z">Along the tool's axis, where the machine has one.</param>
public readonly record struct JogVelocity(double X, double Y, double Z = 0.0)
{
    public bool IsZero => X == 0.0 && Y == 0.0 && Z == 0.0;

    /// <summary>Speed of one axis, in the order of <see cref="MachineAxes.All"/>.</summary>
    public double this[int axis] => axis switch { 0 => X, 1 => Y, 2 => Z, _ => throw new ArgumentOutOfRangeException(nameof(axis)) };

    /// <summary>The same direction, slowed down where an axis would exceed this speed.</summary>
    /// <param name="mmPerMinute">At least 0.</param>
    public JogVelocity NoFasterThan(double mmPerMinute) => Math.Max(Math.Abs(X), Math.Max(Math.Abs(Y), Math.Abs(Z))) > mmPerMinute ? At(mmPerMinute) : this;

    /// <summary>The same direction at another speed of the fastest axis.</summary>
    /// <param name="mmPerMinute">At least 0.</param>
    public JogVelocity At(double mmPerMinute)
    {
        var fastest = Math.Max(Math.Abs(X), Math.Max(Math.Abs(Y), Math.Abs(Z)));
        return fastest == 0.0 ? this : new JogVelocity(X / fastest * mmPerMinute, Y / fastest * mmPerMinute, Z / fastest * mmPerMinute);
    }
}
