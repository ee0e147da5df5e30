using System.Globalization;

namespace Engraver.Core.Geometry;

/// <summary>A plane angle, counter-clockwise positive, stored in degrees (DXF gives degrees, the controller's CR takes degrees). <c>default</c> is
/// zero.</summary>
/// <remarks>Paper 001 takes the cosine of a number of degrees; this type makes that mistake impossible: only <see cref="Cos"/> and <see cref="Sin"/>
/// convert.</remarks>
public readonly record struct Angle : IComparable<Angle>
{
    private Angle(double degrees) => Degrees = degrees;

    public double Degrees { get; }

    public double Radians => Degrees * (Math.PI / 180.0);

    public static Angle Zero => default;

    public static Angle FullTurn => new(360.0);

    public static Angle FromDegrees(double degrees) => new(degrees);

    public static Angle FromRadians(double radians) => new(radians * (180.0 / Math.PI));

    /// <summary>Direction of the vector (x, y), in (-180, 180]. The zero vector has direction 0.</summary>
    public static Angle Direction(double x, double y) => new(Math.Atan2(y, x) * (180.0 / Math.PI));

    /// <summary>Cosine, exact at every multiple of 90 degrees (no 6e-17), so that quadrant points of a table print as whole numbers.</summary>
    public double Cos() => Quadrant() switch { 0 => 1.0, 1 => 0.0, 2 => -1.0, 3 => 0.0, _ => Math.Cos(Math.IEEERemainder(Degrees, 360.0) * (Math.PI / 180.0)) };

    /// <summary>Sine, exact at every multiple of 90 degrees.</summary>
    public double Sin() => Quadrant() switch { 0 => 0.0, 1 => 1.0, 2 => 0.0, 3 => -1.0, _ => Math.Sin(Math.IEEERemainder(Degrees, 360.0) * (Math.PI / 180.0)) };

    /// <summary>The same direction in [0, 360).</summary>
    public Angle Positive()
    {
        var turned = Degrees % 360.0;
        if (turned < 0.0) turned += 360.0;
        return new Angle(turned >= 360.0 ? 0.0 : turned);
    }

    public Angle Abs() => new(Math.Abs(Degrees));

    public int CompareTo(Angle other) => Degrees.CompareTo(other.Degrees);

    public static Angle operator +(Angle left, Angle right) => new(left.Degrees + right.Degrees);

    public static Angle operator -(Angle left, Angle right) => new(left.Degrees - right.Degrees);

    public static Angle operator -(Angle angle) => new(-angle.Degrees);

    public static Angle operator *(Angle angle, double factor) => new(angle.Degrees * factor);

    public static bool operator <(Angle left, Angle right) => left.Degrees < right.Degrees;

    public static bool operator >(Angle left, Angle right) => left.Degrees > right.Degrees;

    public static bool operator <=(Angle left, Angle right) => left.Degrees <= right.Degrees;

    public static bool operator >=(Angle left, Angle right) => left.Degrees >= right.Degrees;

    public override string ToString() => string.Create(CultureInfo.InvariantCulture, $"{Degrees} deg");

    private int Quadrant()
    {
        var turned = Degrees % 360.0;
        if (turned < 0.0) turned += 360.0;
        return turned switch { 0.0 or 360.0 => 0, 90.0 => 1, 180.0 => 2, 270.0 => 3, _ => -1 };
    }
}
