namespace Engraver.Fonts.Strokes;

/// <summary>A line (bulge 0) or an arc between two different points.</summary>
/// <param name="Bulge">The tangent of a quarter of the sweep, positive counter-clockwise.</param>
internal readonly record struct StrokePiece(FontPoint Start, FontPoint End, double Bulge)
{
    public bool IsLine => Bulge == 0;

    /// <summary>In radians, positive counter-clockwise; 0 for a line.</summary>
    public double Sweep => 4 * Math.Atan(Bulge);

    public double Chord => Distance(Start, End);

    /// <summary>Of an arc; positive.</summary>
    public double Radius => Chord * (1 + (Bulge * Bulge)) / (4 * Math.Abs(Bulge));

    public double Length => IsLine ? Chord : Radius * Math.Abs(Sweep);

    /// <summary>Direction of travel at the start, in radians.</summary>
    public double StartDirection => ChordDirection - (Sweep / 2);

    /// <summary>Direction of travel at the end, in radians.</summary>
    public double EndDirection => ChordDirection + (Sweep / 2);

    /// <summary>Of an arc.</summary>
    public FontPoint Centre
    {
        get
        {
            // From the middle of the chord, to the left of the direction of travel.
            var along = (1 - (Bulge * Bulge)) / (4 * Bulge);
            return new FontPoint(((Start.X + End.X) / 2) - ((End.Y - Start.Y) * along), ((Start.Y + End.Y) / 2) + ((End.X - Start.X) * along));
        }
    }

    private double ChordDirection => Math.Atan2(End.Y - Start.Y, End.X - Start.X);

    /// <summary>The arc that leaves <paramref name="start"/> in this direction (radians); a line if the end is straight ahead.</summary>
    public static StrokePiece Leaving(FontPoint start, FontPoint end, double direction)
    {
        var half = Math.IEEERemainder(Math.Atan2(end.Y - start.Y, end.X - start.X) - direction, 2 * Math.PI);
        return new StrokePiece(start, end, Math.Abs(half) < 1e-9 ? 0 : Math.Tan(half / 2));
    }

    public static double Distance(FontPoint a, FontPoint b) => Math.Sqrt(((a.X - b.X) * (a.X - b.X)) + ((a.Y - b.Y) * (a.Y - b.Y)));

    public StrokePiece Reversed() => new(End, Start, -Bulge);

    public StrokePiece Placed(double x, double y, double scale) => new(new((Start.X * scale) + x, (Start.Y * scale) + y), new((End.X * scale) + x, (End.Y * scale) + y), Bulge);

    /// <param name="at">The fraction of the length, 0 at the start.</param>
    public FontPoint PointAt(double at)
    {
        if (at <= 0) return Start;
        if (at >= 1) return End;
        if (IsLine) return new FontPoint(Start.X + ((End.X - Start.X) * at), Start.Y + ((End.Y - Start.Y) * at));
        var centre = Centre;
        var angle = Math.Atan2(Start.Y - centre.Y, Start.X - centre.X) + (Sweep * at);
        return new FontPoint(centre.X + (Radius * Math.Cos(angle)), centre.Y + (Radius * Math.Sin(angle)));
    }

    /// <returns>The fraction of the length at the point, which is on the line or circle; outside of 0 to 1 if it is not on the piece.</returns>
    public double FractionAt(FontPoint point)
    {
        if (IsLine)
        {
            var (dx, dy) = (End.X - Start.X, End.Y - Start.Y);
            return (((point.X - Start.X) * dx) + ((point.Y - Start.Y) * dy)) / ((dx * dx) + (dy * dy));
        }

        var centre = Centre;
        var turn = Math.Atan2(point.Y - centre.Y, point.X - centre.X) - Math.Atan2(Start.Y - centre.Y, Start.X - centre.X);
        // Between half of the gap before the start and half of the gap after the end.
        return (Math.IEEERemainder(turn - (Sweep / 2), 2 * Math.PI) / Sweep) + 0.5;
    }

    public StrokePiece Part(double from, double to) => new(PointAt(from), PointAt(to), IsLine ? 0 : Math.Tan(Sweep * (to - from) / 4));

    /// <returns>The distance of a point from the nearest point of the piece.</returns>
    public double DistanceTo(FontPoint point)
    {
        var at = FractionAt(point);
        if (at is < 0 or > 1) return Math.Min(Distance(point, Start), Distance(point, End));
        return IsLine ? Distance(point, PointAt(at)) : Math.Abs(Distance(point, Centre) - Radius);
    }

    /// <summary>The points of the piece that its smallest upright rectangle goes through: its ends, and where an arc is horizontal or vertical.</summary>
    public IEnumerable<FontPoint> Extremes()
    {
        yield return Start;
        yield return End;
        if (IsLine) yield break;
        for (var quarter = 0; quarter < 4; quarter++)
        {
            var (sin, cos) = Math.SinCos(quarter * Math.PI / 2);
            var point = new FontPoint(Centre.X + (Radius * cos), Centre.Y + (Radius * sin));
            if (FractionAt(point) is > 0 and < 1) yield return point;
        }
    }
}
