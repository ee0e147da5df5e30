namespace Engraver.Simulator.Motion;

/// <summary>CR: the current point is at angle theta on a circle of radius r; positive sweep is counter-clockwise (galil-dmc.md B.3).</summary>
internal sealed class CircularSegment : VectorSegment
{
    private readonly double _centreX;
    private readonly double _centreY;
    private readonly double _radius;
    private readonly double _theta;
    private readonly double _sweep;

    /// <param name="theta">Degrees, rounded to the angle resolution.</param>
    /// <param name="sweep">Signed degrees, rounded to the angle resolution; not zero.</param>
    public CircularSegment(double startX, double startY, double radius, double theta, double sweep)
    {
        _radius = radius;
        _theta = theta;
        _sweep = sweep;
        _centreX = startX - (_radius * Cosine(_theta));
        _centreY = startY - (_radius * Sine(_theta));
        Length = _radius * Math.Abs(_sweep) * (Math.PI / 180);
    }

    public override void PointAt(double distance, Span<double> point)
    {
        var angle = AngleAt(distance);
        point[0] = _centreX + (_radius * Cosine(angle));
        point[1] = _centreY + (_radius * Sine(angle));
    }

    /// <summary>Within a quarter of the circle no axis changes direction.</summary>
    public override double OneWayUntil(double distance)
    {
        var angle = AngleAt(distance);
        var quarter = 90 * (_sweep > 0 ? Math.Floor((angle / 90) + 1) : Math.Ceiling((angle / 90) - 1));
        return Math.Min(Length, distance + ((quarter - angle) / _sweep * Length));
    }

    /// <summary>The arc between two distances, in counts of the axes of the first two slots, before rounding and relative to the sequence frame's
    /// origin.</summary>
    public ArcCourse Course(double from, double to, double scaleX, double scaleY) =>
        new(_centreX * scaleX, _centreY * scaleY, _radius * scaleX, _radius * scaleY, AngleAt(from), AngleAt(to) - AngleAt(from));

    public override double TangentAt(double distance) => AngleAt(distance) + (_sweep > 0 ? 90 : -90);

    private double AngleAt(double distance) => _theta + (distance >= Length ? _sweep : _sweep * (distance / Length));

    // Degrees are reduced before the conversion to radians, so that 90 and 360 give exact zeros and ones and full circles close.
    private static double Sine(double degrees) => Cosine(degrees - 90);

    private static double Cosine(double degrees)
    {
        var turn = Math.Abs(Math.IEEERemainder(degrees, 360));
        return turn switch { 90 => 0, 0 => 1, 180 => -1, _ => Math.Cos(turn * (Math.PI / 180)) };
    }
}
