namespace Engraver.Core.Machines;

/// <summary>A position of the axes that a job moves, in counts, in the order of <see cref="MachineAxes.All"/>. In the job's frame the drawing's zero is 0,0,0;
/// the controller's own zero may be elsewhere. A controller holds 32 bits; a drawing may be farther from its own zero.</summary>
/// <param name="Z">Counts of the tool's axis. Up is positive where its counts per millimetre are positive; 0 on a machine without one.</param>
public readonly record struct CountsPoint(long X, long Y, int Z = 0)
{
    /// <summary>Counts of the axis with this index in <see cref="MachineAxes.All"/>.</summary>
    public long this[int axis] => axis switch { 0 => X, 1 => Y, 2 => Z, _ => throw new ArgumentOutOfRangeException(nameof(axis)) };

    /// <summary>From the values that a controller reports for its axes in order; a missing axis counts 0.</summary>
    public static CountsPoint From(ReadOnlySpan<double> axes) => new((int)axes[0], axes.Length > 1 ? (int)axes[1] : 0, axes.Length > 2 ? (int)axes[2] : 0);

    public static CountsPoint operator +(CountsPoint left, CountsPoint right) => new(left.X + right.X, left.Y + right.Y, left.Z + right.Z);

    public static CountsPoint operator -(CountsPoint left, CountsPoint right) => new(left.X - right.X, left.Y - right.Y, left.Z - right.Z);

    /// <summary>True when the position in plan is the same, at any height.</summary>
    public bool IsSameInPlan(CountsPoint other) => (X, Y) == (other.X, other.Y);
}
