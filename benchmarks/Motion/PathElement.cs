namespace Engraver.Benchmarks.Motion;

/// <summary>A line or an arc of a path. Millimetres and radians.</summary>
internal readonly record struct PathElement
{
    private PathElement(Plane start, Plane direction, double length) =>
        (From, To, Direction, Radius, Length) = (start, start + (direction * length), direction, double.PositiveInfinity, length);

    private PathElement(Plane centre, double radius, double start, double sweep)
    {
        (Centre, Radius, Start, Sweep, Length) = (centre, radius, start, sweep, radius * Math.Abs(sweep));
        (From, To) = (PointAt(0.0), PointAt(Length));
    }

    public Plane From { get; }

    public Plane To { get; }

    public Plane Centre { get; }

    /// <summary>Of a line, length 1.</summary>
    public Plane Direction { get; }

    /// <summary>Infinite for a line.</summary>
    public double Radius { get; }

    /// <summary>Angle of the start of an arc, seen from its centre.</summary>
    public double Start { get; }

    /// <summary>Positive to the left.</summary>
    public double Sweep { get; }

    public double Length { get; }

    public bool IsLine => double.IsInfinity(Radius);

    public Plane FirstTangent => TangentAt(0.0);

    public Plane LastTangent => TangentAt(Length);

    public static PathElement Line(Plane start, Plane end) => new(start, (end - start) * (1.0 / (end - start).Length), (end - start).Length);

    public static PathElement Arc(Plane centre, double radius, double start, double sweep) => new(centre, radius, start, sweep);

    public Plane PointAt(double along) => IsLine ? From + (Direction * along) : Centre + (Plane.At(Start + (Math.Sign(Sweep) * along / Radius)) * Radius);

    public Plane TangentAt(double along) => IsLine ? Direction : Plane.At(Start + (Math.Sign(Sweep) * along / Radius)).Left * Math.Sign(Sweep);

    /// <summary>The element without a length at its start and at its end.</summary>
    public PathElement Without(double atStart, double atEnd)
    {
        if (IsLine) return new PathElement(PointAt(atStart), Direction, Length - atStart - atEnd);
        return Arc(Centre, Radius, Start + (Math.Sign(Sweep) * atStart / Radius), Math.Sign(Sweep) * (Length - atStart - atEnd) / Radius);
    }
}
