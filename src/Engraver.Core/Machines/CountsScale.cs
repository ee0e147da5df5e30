using Engraver.Core.Geometry;

namespace Engraver.Core.Machines;

/// <summary>Converts millimetres to counts: the only place where the unit changes. End points are rounded, never increments, so errors cannot accumulate
/// (galil-dmc.md J.2).</summary>
/// <remarks>"Exact" values are counts that are not rounded yet; they are carried in the geometry types of Core, whose unit is then the count.</remarks>
/// <param name="X">Counts per millimetre of the drawing's X; negative mirrors.</param>
/// <param name="Y">Counts per millimetre of the drawing's Y; negative mirrors.</param>
/// <param name="Z">Counts per millimetre of height; negative where the axis counts downwards, 0 for a machine without such an axis.</param>
public readonly record struct CountsScale(double X, double Y, double Z = 0.0)
{
    /// <summary>A point farther from the drawing's zero is not a whole number of counts in a double.</summary>
    public const double MostCounts = 1L << 52;

    /// <summary>True when a circle in millimetres is a circle in counts; otherwise it is an ellipse, which CR cannot cut.</summary>
    public bool KeepsCircles => Math.Abs(X) == Math.Abs(Y);

    /// <summary>Counts per millimetre of the coarser axis of the plane, whose count is the longest. A feed converted with it is not exceeded in any
    /// direction.</summary>
    public double Smallest => Math.Min(Math.Abs(X), Math.Abs(Y));

    /// <summary>Counts per millimetre of the finer axis of the plane.</summary>
    public double Largest => Math.Max(Math.Abs(X), Math.Abs(Y));

    /// <summary>Rounds half away from zero. The caller first ensures that the point can be counted (<see cref="Holds"/>, <see cref="Counts"/>).</summary>
    public static CountsPoint Round(Point2D exact) => new(
        checked((long)Math.Round(exact.X, MidpointRounding.AwayFromZero)),
        checked((long)Math.Round(exact.Y, MidpointRounding.AwayFromZero)));

    public Point2D Exact(Point2D millimetres) => new(X * millimetres.X, Y * millimetres.Y);

    /// <summary>Counts, rounded or not, as millimetres of the drawing.</summary>
    public Point2D ToMillimetres(double x, double y) => new(x / X, y / Y);

    public CountsPoint ToCounts(Point2D millimetres) => Round(Exact(millimetres));

    /// <summary>A height in counts; 0 on a machine without a Z axis.</summary>
    public int ToHeight(double millimetres) => checked((int)Math.Round(Z * millimetres, MidpointRounding.AwayFromZero));

    /// <summary>Counts of the Z axis as a height in millimetres; 0 on a machine without one.</summary>
    public double ToMillimetres(double z) => Z == 0.0 ? 0.0 : z / Z;

    /// <summary>The same arc in counts. A mirrored X turns the angle into 180 - angle, a mirrored Y into -angle; each reverses the sweep.</summary>
    /// <remarks>Only when <see cref="KeepsCircles"/>.</remarks>
    public ArcSegment Exact(ArcSegment millimetres)
    {
        var start = X < 0.0 ? Angle.FromDegrees(180.0) - millimetres.Start : millimetres.Start;
        if (Y < 0.0) start = -start;
        var sweep = X < 0.0 == Y < 0.0 ? millimetres.Sweep : -millimetres.Sweep;
        return new ArcSegment(Exact(millimetres.Centre), millimetres.Radius * Math.Abs(X), start, sweep);
    }

    /// <summary>True when a point of the drawing, millimetres, is near enough to its zero to be a whole number of counts: a double holds one only below
    /// 2^53.</summary>
    public bool Counts(Point2D millimetres) => Math.Abs(X * millimetres.X) < MostCounts && Math.Abs(Y * millimetres.Y) < MostCounts;

    /// <summary>True when every point of the box (millimetres) fits int32 in counts from <paramref name="origin"/>, the range of a controller.</summary>
    public bool Holds(Bounds2D millimetres, CountsPoint origin) =>
        Fits(X * millimetres.MinX, origin.X) && Fits(X * millimetres.MaxX, origin.X) && Fits(Y * millimetres.MinY, origin.Y) && Fits(Y * millimetres.MaxY, origin.Y);

    /// <summary>True when a height fits int32 in counts.</summary>
    public bool HoldsHeight(double millimetres) => Fits(Z * millimetres, 0);

    private static bool Fits(double counts, long origin) => Math.Abs(counts) < MostCounts && Math.Abs(counts - origin) < int.MaxValue;
}

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
    public bool IsBeside(CountsPoint other) => (X, Y) == (other.X, other.Y);
}
