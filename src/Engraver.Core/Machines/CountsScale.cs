using Engraver.Core.Geometry;

namespace Engraver.Core.Machines;

/// <summary>Converts between millimetres and counts: with <see cref="AxisScale"/> the only place where this unit changes. End points are rounded, never
/// increments, so errors cannot accumulate (galil-dmc.md J.2).</summary>
/// <remarks>"Exact" values are counts that are not rounded yet; they are carried in the geometry types of Core, whose unit is then the count.</remarks>
/// <param name="X">Of the drawing's X.</param>
/// <param name="Y">Of the drawing's Y.</param>
/// <param name="Z">Of the height; <see cref="AxisScale.IsNone"/> for a machine without such an axis.</param>
public readonly record struct CountsScale(AxisScale X, AxisScale Y, AxisScale Z = default)
{
    /// <summary>A point farther from the drawing's zero is not a whole number of counts in a double.</summary>
    public const double MaxCounts = 1L << 52;

    /// <summary>True when a circle in millimetres is a circle in counts; otherwise it is an ellipse, which CR cannot cut.</summary>
    public bool IsUniform => X.CountsOf(1.0) == Y.CountsOf(1.0);

    /// <summary>The coarser axis of the plane, whose count is the longest; not mirrored. A feed converted with it is not exceeded in any direction.</summary>
    public AxisScale Coarser => new(Math.Min(X.CountsOf(1.0), Y.CountsOf(1.0)));

    /// <summary>The finer axis of the plane; not mirrored.</summary>
    public AxisScale Finer => new(Math.Max(X.CountsOf(1.0), Y.CountsOf(1.0)));

    /// <summary>Counts along the path while every axis moves a millimetre: no path of this length in millimetres has more.</summary>
    public AxisScale Diagonal => new(Math.Sqrt(Square(X) + Square(Y) + Square(Z)));

    /// <summary>From counts per millimetre; negative mirrors, 0 for no Z axis.</summary>
    public static CountsScale From(double x, double y, double z = 0.0) => new(new AxisScale(x), new AxisScale(y), new AxisScale(z));

    /// <summary>Rounds half away from zero. The caller first ensures that the point can be counted (<see cref="IsInRange"/>, <see cref="Counts"/>).</summary>
    public static CountsPoint Round(Point2D exact) => new(
        checked((long)Math.Round(exact.X, MidpointRounding.AwayFromZero)),
        checked((long)Math.Round(exact.Y, MidpointRounding.AwayFromZero)));

    public Point2D Exact(Point2D millimetres) => new(X.Exact(millimetres.X), Y.Exact(millimetres.Y));

    /// <summary>Counts, rounded or not, as millimetres of the drawing.</summary>
    public Point2D ToMillimetres(double x, double y) => new(X.ToMillimetres(x), Y.ToMillimetres(y));

    public Vector2D ToMillimetres(Vector2D counts) => new(X.ToMillimetres(counts.X), Y.ToMillimetres(counts.Y));

    public CountsPoint ToCounts(Point2D millimetres) => Round(Exact(millimetres));

    /// <summary>A height in counts; 0 on a machine without a Z axis.</summary>
    public int ToHeight(double millimetres) => checked((int)Math.Round(Z.Exact(millimetres), MidpointRounding.AwayFromZero));

    /// <summary>Counts of the Z axis as a height in millimetres; 0 on a machine without one.</summary>
    public double ToMillimetres(double z) => Z.IsNone ? 0.0 : Z.ToMillimetres(z);

    /// <summary>The same arc in counts. A mirrored X turns the angle into 180 - angle, a mirrored Y into -angle; each reverses the sweep.</summary>
    /// <remarks>Only when <see cref="IsUniform"/>.</remarks>
    public ArcSegment Exact(ArcSegment millimetres)
    {
        var start = X.IsMirrored ? Angle.FromDegrees(180.0) - millimetres.Start : millimetres.Start;
        if (Y.IsMirrored) start = -start;
        var sweep = X.IsMirrored == Y.IsMirrored ? millimetres.Sweep : -millimetres.Sweep;
        return new ArcSegment(Exact(millimetres.Centre), X.CountsOf(millimetres.Radius), start, sweep);
    }

    /// <summary>True when a point of the drawing, millimetres, is near enough to its zero to be a whole number of counts: a double holds one only below
    /// 2^53.</summary>
    public bool Counts(Point2D millimetres) => Math.Abs(X.Exact(millimetres.X)) < MaxCounts && Math.Abs(Y.Exact(millimetres.Y)) < MaxCounts;

    /// <summary>True when every point of the box (millimetres) fits int32 in counts from <paramref name="origin"/>, the range of a controller.</summary>
    public bool IsInRange(Bounds2D millimetres, CountsPoint origin) =>
        Fits(X.Exact(millimetres.MinX), origin.X) && Fits(X.Exact(millimetres.MaxX), origin.X) && Fits(Y.Exact(millimetres.MinY), origin.Y) && Fits(Y.Exact(millimetres.MaxY), origin.Y);

    /// <summary>True when a height fits int32 in counts.</summary>
    public bool IsHeightInRange(double millimetres) => Fits(Z.Exact(millimetres), 0);

    private static bool Fits(double counts, long origin) => Math.Abs(counts) < MaxCounts && Math.Abs(counts - origin) < int.MaxValue;

    private static double Square(AxisScale axis) => axis.CountsPerMillimetre * axis.CountsPerMillimetre;
}
