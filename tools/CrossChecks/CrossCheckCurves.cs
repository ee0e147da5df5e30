namespace Engraver.Tools.CrossChecks;

/// <summary>Turns a record into smooth pieces of curves; null when it is not a curve.</summary>
internal static class CrossCheckCurves
{
    public static List<CrossCheckPiece>? Read(CrossCheckRecord record) => record.Type switch
    {
        "LINE" => Lines([record.Point(10), record.Point(11)]),
        "CIRCLE" => Arc(record, 0.0, 360.0),
        "ARC" => Arc(record, record.Number(50, double.NaN), Sweep(record.Number(50, double.NaN), record.Number(51, double.NaN), 360.0)),
        "ELLIPSE" => Ellipse(record),
        "LWPOLYLINE" => Polyline(LwVertices(record), ((int)record.Number(70, 0.0) & 1) != 0, CrossCheckFrame.FromExtrusion(record)),
        "POLYLINE" => OldPolyline(record),
        "SPLINE" => CrossCheckSplines.Read(record),
        _ => null,
    };

    public static List<CrossCheckPiece> Lines(IReadOnlyList<CrossCheckPoint> points)
    {
        var lines = new List<CrossCheckPiece>();
        for (var i = 1; i < points.Count; i++)
        {
            lines.Add(new CrossCheckPiece(points[i - 1], points[i]));
        }

        return lines;
    }

    /// <summary>Modulo a turn; but whole turns, and up to 0.001 rad beyond them, are one turn: programs round 2 pi up.</summary>
    private static double Sweep(double start, double end, double turn)
    {
        var written = end - start;
        if (Math.Abs(written) <= 1e-9) return 0.0;
        var beyond = written - (turn * Math.Floor(written / turn));
        var slack = written < turn ? 1e-9 : turn * 1e-3 / Math.Tau;
        return beyond >= turn - 1e-9 || (Math.Abs(written) >= turn - 1e-9 && beyond <= slack) ? turn : beyond;
    }

    private static List<CrossCheckPiece> Arc(CrossCheckRecord record, double start, double sweep)
    {
        var r = Math.Abs(record.Number(40, double.NaN));
        return Round(CrossCheckFrame.FromExtrusion(record), record.Point(10), new CrossCheckPoint(r, 0, 0), new CrossCheckPoint(0, r, 0), start * Math.PI / 180.0, sweep * Math.PI / 180.0);
    }

    private static List<CrossCheckPiece> Ellipse(CrossCheckRecord record)
    {
        var (major, up, ratio) = (record.Point(11), CrossCheckFrame.FromExtrusion(record).Z, record.Number(40, double.NaN));
        var minor = ratio * new CrossCheckPoint((up.Y * major.Z) - (up.Z * major.Y), (up.Z * major.X) - (up.X * major.Z), (up.X * major.Y) - (up.Y * major.X));
        var start = record.Number(41, 0.0);
        return Round(CrossCheckFrame.World, record.Point(10), major, minor, start, Sweep(start, record.Number(42, Math.Tau), Math.Tau));
    }

    /// <summary>Divides the curve centre + u cos + v sin (angles in radians) into pieces of a quarter turn or less.</summary>
    private static List<CrossCheckPiece> Round(CrossCheckFrame frame, CrossCheckPoint centre, CrossCheckPoint u, CrossCheckPoint v, double start, double sweep)
    {
        var pieces = new List<CrossCheckPiece>();
        var count = sweep == 0.0 ? 0 : (int)Math.Ceiling(Math.Abs(sweep) / (Math.PI / 2.0));
        for (var i = 0; i < count; i++)
        {
            var (from, step) = (start + (sweep * i / count), sweep / count);
            pieces.Add(new CrossCheckPiece(t => frame.At(centre + (Math.Cos(from + (step * t)) * u) + (Math.Sin(from + (step * t)) * v))));
        }

        return pieces;
    }

    private static List<(CrossCheckPoint Place, double Bulge)> LwVertices(CrossCheckRecord record)
    {
        var (vertices, z) = (new List<(CrossCheckPoint Place, double Bulge)>(), record.Number(38, 0.0));
        foreach (var tag in record.Tags)
        {
            if (tag.Code == 10) vertices.Add((new CrossCheckPoint(record.Number(tag), double.NaN, z), 0.0));
            else if (tag.Code == 20 && vertices.Count > 0) vertices[^1] = (vertices[^1].Place with { Y = record.Number(tag) }, vertices[^1].Bulge);
            else if (tag.Code == 42 && vertices.Count > 0) vertices[^1] = (vertices[^1].Place, record.Number(tag));
        }

        return vertices;
    }

    private static List<CrossCheckPiece>? OldPolyline(CrossCheckRecord record)
    {
        var flags = (int)record.Number(70, 0.0);
        if ((flags & (16 | 64)) != 0) return null;
        var flat = (flags & 8) == 0;
        var drawn = record.Vertices.Where(vertex => ((int)vertex.Number(70, 0.0) & 16) == 0);
        var vertices = drawn.Select(vertex => (flat ? vertex.Point(10) with { Z = record.Number(30, 0.0) } : vertex.Point(10), flat ? vertex.Number(42, 0.0) : 0.0)).ToList();
        return Polyline(vertices, (flags & 1) != 0, flat ? CrossCheckFrame.FromExtrusion(record) : CrossCheckFrame.World);
    }

    private static List<CrossCheckPiece> Polyline(List<(CrossCheckPoint Place, double Bulge)> vertices, bool closed, CrossCheckFrame frame)
    {
        var pieces = new List<CrossCheckPiece>();
        for (var i = 0; i < vertices.Count - (closed ? 0 : 1); i++)
        {
            var ((a, bulge), (b, _)) = (vertices[i], vertices[(i + 1) % vertices.Count]);
            if (a == b) continue;
            if (Math.Abs(bulge) < 1e-8 || (a.X == b.X && a.Y == b.Y)) pieces.AddRange(Lines([frame.At(a), frame.At(b)]));
            else pieces.AddRange(Bulge(frame, a, b, bulge));
        }

        return pieces;
    }

    /// <summary>The arc of a bulge b: its centre is on the perpendicular bisector of the chord, (1/b - b)/2 half chords to the left.</summary>
    private static List<CrossCheckPiece> Bulge(CrossCheckFrame frame, CrossCheckPoint a, CrossCheckPoint b, double bulge)
    {
        var (half, lift) = (0.5 * (b - a), ((1.0 / bulge) - bulge) / 2.0);
        var centre = a + half + (lift * new CrossCheckPoint(-half.Y, half.X, 0.0));
        var (u, v) = (a - centre, new CrossCheckPoint(-(a.Y - centre.Y), a.X - centre.X, 0.0));
        return Round(frame, centre, u with { Z = 0.0 }, v, 0.0, 4.0 * Math.Atan(bulge));
    }
}

/// <summary>A smooth piece of a curve: a function of a parameter from 0 to 1, or the straight line between two points.</summary>
internal readonly struct CrossCheckPiece
{
    private readonly CrossCheckPoint _from;
    private readonly CrossCheckPoint _to;
    private readonly Func<double, CrossCheckPoint>? _curve;

    public CrossCheckPiece(CrossCheckPoint from, CrossCheckPoint to) => (_from, _to) = (from, to);

    public CrossCheckPiece(Func<double, CrossCheckPoint> curve) => _curve = curve;

    public bool IsStraight => _curve is null;

    public CrossCheckPoint At(double t) => _curve is null ? _from + (t * (_to - _from)) : _curve(t);
}
