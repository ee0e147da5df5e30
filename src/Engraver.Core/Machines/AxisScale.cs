namespace Engraver.Core.Machines;

/// <summary>Converts between millimetres and counts of one axis.</summary>
/// <param name="CountsPerMillimetre">Negative mirrors the axis. To be shown, stored and checked; calculations use the methods.</param>
public readonly record struct AxisScale(double CountsPerMillimetre)
{
    /// <summary>The machine has no such axis (also <c>default</c>).</summary>
    public bool IsNone => CountsPerMillimetre == 0.0;

    /// <summary>The number is finite and not 0.</summary>
    public bool IsUsable => double.IsFinite(CountsPerMillimetre) && CountsPerMillimetre != 0.0;

    /// <summary>The axis counts against the drawing's axis.</summary>
    public bool IsMirrored => CountsPerMillimetre < 0.0;

    /// <summary>+1 where the axis counts with the drawing's axis, -1 where against it; 0 for no axis.</summary>
    public int Sign => Math.Sign(CountsPerMillimetre);

    /// <summary>The same axis counting in the other direction.</summary>
    public AxisScale Mirrored() => new(-CountsPerMillimetre);

    /// <summary>A position in counts, not rounded.</summary>
    public double Exact(double millimetres) => CountsPerMillimetre * millimetres;

    /// <summary>A position, rounded or not, in millimetres.</summary>
    public double ToMillimetres(double counts) => counts / CountsPerMillimetre;

    /// <summary>A length, a speed or an acceleration in counts: in any direction, so the sign is that of the argument.</summary>
    public double CountsOf(double millimetres) => millimetres * Math.Abs(CountsPerMillimetre);

    /// <summary>A length, a speed or an acceleration in millimetres; the sign is that of the argument.</summary>
    public double LengthOf(double counts) => counts / Math.Abs(CountsPerMillimetre);

    /// <summary>The scale by a move that was measured, in the same direction.</summary>
    /// <param name="counts">Of the move, above 0.</param>
    /// <param name="millimetres">Its length, above 0.</param>
    public AxisScale Measured(double counts, double millimetres) => new(Math.CopySign(counts / millimetres, CountsPerMillimetre));
}
