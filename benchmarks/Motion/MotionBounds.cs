namespace Engraver.Benchmarks.Motion;

/// <summary>What bounds the motion along a path. Millimetres and seconds.</summary>
/// <param name="Feed">Largest speed.</param>
/// <param name="Acceleration">Largest acceleration in any direction.</param>
/// <param name="Tolerance">Largest distance between a corner and the arc that rounds it.</param>
/// <param name="CountsPerMm">Resolution of the machine.</param>
internal readonly record struct MotionBounds(double Feed, double Acceleration, double Tolerance, double CountsPerMm)
{
    /// <summary>Time between two samples of the controller, in which the change of velocity at a corner takes place.</summary>
    public const double Sample = 0.001;

    private const double SmallestRadiusCounts = 10.0;

    public double SmallestRadius => SmallestRadiusCounts / CountsPerMm;

    /// <summary>Largest speed on an arc.</summary>
    public double OnArc(double radius) => double.IsInfinity(radius) ? Feed : Math.Min(Feed, Math.Sqrt(Acceleration * radius));

    /// <summary>Largest speed through a corner: the change of velocity fits one sample. Where corners follow each other within the way of a sample, the
    /// change per way bounds the speed, as on an arc.</summary>
    /// <param name="turn">Radians.</param>
    /// <param name="spacing">Mean length of the elements before and after it.</param>
    public double ThroughCorner(double turn, double spacing)
    {
        var jump = 2.0 * Math.Sin(Math.Abs(turn) / 2.0);
        return jump < 1e-12 ? double.PositiveInfinity : Math.Min(Acceleration * Sample / jump, Math.Sqrt(Acceleration * spacing / jump));
    }
}
