namespace Engraver.Core.Geometry;

/// <summary>An ellipse or a part of one, in space: Centre + First cos(a) + Second sin(a) for a from <see cref="Start"/> over <see cref="Sweep"/>.</summary>
/// <remarks>The two vectors are conjugate half-diameters: perpendicular when an ellipse was drawn, not when a circle was scaled unequally or tilted. A whole
/// turn is exactly +-360 degrees.</remarks>
public readonly record struct EllipseArc(Vector3D Centre, Vector3D First, Vector3D Second, Angle Start, Angle Sweep)
{
    /// <summary>Relative difference of two half-diameters below which they form a circle; the rounding of deeply nested inserts is far smaller.</summary>
    private const double EqualDiameters = 1e-9;

    /// <summary>Slope below which a tilted circle counts as level: its plan is then an ellipse whose axes differ by less than 1e-12 of the radius.</summary>
    private const double FlatSlope = 1e-6;

    public bool IsFullTurn => Math.Abs(Sweep.Degrees) == 360.0;

    /// <summary>Level, with half-diameters equally long and perpendicular: a circle or an arc, within rounding.</summary>
    public bool IsCircular
    {
        get
        {
            var (first, second) = (First.Length, Second.Length);
            return Math.Abs(First.Z) <= FlatSlope * first && Math.Abs(Second.Z) <= FlatSlope * second
                && Math.Abs(first - second) <= EqualDiameters * first && Math.Abs(First.Dot(Second)) <= EqualDiameters * first * first;
        }
    }

    /// <summary>The arc in plan; only where <see cref="IsCircular"/> holds.</summary>
    public ArcSegment ToArc()
    {
        var mirrored = (First.X * Second.Y) - (First.Y * Second.X) < 0.0;
        var turn = Angle.Direction(First.X, First.Y);
        return new ArcSegment(new Point2D(Centre.X, Centre.Y), First.Length, (mirrored ? turn - Start : turn + Start).Positive(), mirrored ? -Sweep : Sweep);
    }

    /// <summary>The same points as rational parabolas, each over at most a quarter turn.</summary>
    public RationalCurve ToCurve()
    {
        var count = Math.Max(1, (int)Math.Ceiling(Math.Abs(Sweep.Degrees) / 90.0));
        var spans = new BezierSpan[count];
        var step = Sweep * (1.0 / count);
        for (var i = 0; i < count; i++)
        {
            var from = Start + (step * i);
            var to = IsFullTurn && i == count - 1 ? Start : Start + (step * (i + 1)); // the last end is exactly the first start
            spans[i] = Span(from, from + (step * 0.5), to, (step * 0.5).Cos());
        }

        return new RationalCurve(SegmentKind.Ellipse, spans);
    }

    private BezierSpan Span(Angle from, Angle middle, Angle to, double weight)
    {
        var (start, shoulder, end) = (PointAt(from), (Centre * weight) + Offset(middle), PointAt(to));
        return new BezierSpan([start.X, start.Y, start.Z, 1.0, shoulder.X, shoulder.Y, shoulder.Z, weight, end.X, end.Y, end.Z, 1.0]);
    }

    private Vector3D PointAt(Angle angle) => Centre + Offset(angle);

    private Vector3D Offset(Angle angle) => (First * angle.Cos()) + (Second * angle.Sin());
}
