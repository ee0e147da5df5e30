namespace Engraver.Simulator.Motion;

/// <summary>CR: the current point lies at angle theta on a circle of radius r; positive sweep is counter-clockwise (galil-dmc.md B.3).</summary>
internal sealed class CircularSegment : VectorSegment
{
    private readonly double centreX;
    private readonly double centreY;
    private readonly double radius;
    private readonly double theta;
    private readonly double sweep;

    /// <param name="theta">Degrees, after the angle quantum.</param>
    /// <param name="sweep">Signed degrees, after the angle quantum; not zero.</param>
    public CircularSegment(double startX, double startY, double radius, double theta, double sweep)
    {
        this.radius = radius;
        this.theta = theta;
        this.sweep = sweep;
        centreX = startX - (radius * Cosine(theta));
        centreY = startY - (radius * Sine(theta));
        Length = radius * Math.Abs(sweep) * (Math.PI / 180);
    }

    public override void PointAt(double distance, Span<double> point)
    {
        double angle = AngleAt(distance);
        point[0] = centreX + (radius * Cosine(angle));
        point[1] = centreY + (radius * Sine(angle));
    }

    public override double TangentAt(double distance) => AngleAt(distance) + (sweep > 0 ? 90 : -90);

    private double AngleAt(double distance) => theta + (distance >= Length ? sweep : sweep * (distance / Length));

    // Degrees are reduced before they become radians, so that 90 and 360 give exact zeros and ones and full circles close.
    private static double Sine(double degrees) => Cosine(degrees - 90);

    private static double Cosine(double degrees)
    {
        double turn = Math.Abs(Math.IEEERemainder(degrees, 360));
        return turn switch { 90 => 0, 0 => 1, 180 => -1, _ => Math.Cos(turn * (Math.PI / 180)) };
    }
}
