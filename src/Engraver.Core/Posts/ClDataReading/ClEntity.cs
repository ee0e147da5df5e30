using System.Globalization;
using Engraver.Core.Geometry;

namespace Engraver.Core.Posts.ClDataReading;

/// <summary>The pairs of one DXF entity as CL data has them, and the path along it. Only entities parallel to the plane of the drawing, seen from above or from
/// below.</summary>
/// <param name="Type">LINE, ARC, CIRCLE, ELLIPSE or SPLINE.</param>
/// <param name="Line">Line of the file, from 1.</param>
internal sealed record ClEntity(string Type, int Line)
{
    /// <summary>Largest angle from the start of an arc to its end, degrees: a hundred turns.</summary>
    private const double MostDegrees = 36_000.0;

    private readonly List<(int Code, string Value)> _pairs = [];

    public string Layer => _pairs.Where(pair => pair.Code == 8).Select(pair => pair.Value.Trim()).FirstOrDefault() ?? "";

    /// <summary>The first height that is not 0, as written; null when the whole entity is in the plane.</summary>
    public string? Height => _pairs.Where(pair => pair.Code is 30 or 31 or 38 or 39 && !(double.TryParse(pair.Value, NumberStyles.Float, CultureInfo.InvariantCulture, out var height) && height == 0.0)).Select(pair => pair.Value.Trim()).FirstOrDefault();

    public void Add(int code, string value) => _pairs.Add((code, value));

    /// <summary>Lines and arcs, in the direction of travel; null when a number is missing, duplicate or invalid, with its name.</summary>
    public IEnumerable<Segment>? Path(out string reason)
    {
        reason = "";
        try
        {
            if (_pairs.Any(pair => pair.Code is 60 or 67 && Parse(pair) != 0.0)) reason = Wording.Get("ClDataReader.HiddenOrOnPaper");
            else if (Maybe(210, 0.0) != 0.0 || Maybe(220, 0.0) != 0.0 || Math.Abs(Maybe(230, 1.0)) != 1.0) reason = Wording.Get("ClDataReader.Tilted");
            if (reason.Length > 0) return null;
            return Type switch
            {
                "LINE" => [Segment.FromLine(new Point2D(One(10), One(20)), new Point2D(One(11), One(21)))],
                "ARC" => Round(One(50), One(51)),
                "CIRCLE" => Round(Maybe(1040, 0.0), Maybe(1040, 0.0) + 360.0), // its start is in the extended data
                "ELLIPSE" => ClCurves.Ellipse(new Point2D(One(10), One(20)), new Vector2D(One(11), One(21)), One(40) * Maybe(230, 1.0), One(41), One(42)),
                "SPLINE" => ClCurves.Spline((int)One(71), All(40), All(10).Zip(All(20), (x, y) => new Point2D(x, y)).ToArray(), All(41), All(10).Length == All(20).Length),
                _ => throw new FormatException(Type),
            };
        }
        catch (FormatException missing)
        {
            reason = Wording.Get("ClDataReader.BadGroupValue", missing.Message);
            return null;
        }
    }

    /// <summary>Counter-clockwise in the entity's own system, which is mirrored in x when it is seen from below. In quarters of a turn at most, as the judges
    /// require arcs.</summary>
    private IEnumerable<Segment> Round(double start, double end)
    {
        var (isBelow, radius, sweep) = (Maybe(230, 1.0) < 0.0, One(40), end - start);
        if (!(radius > 0.0)) throw new FormatException("40");
        if (Math.Abs(sweep) > MostDegrees) throw new FormatException("50");
        while (sweep <= 0.0) sweep += 360.0;
        while (sweep > 360.0) sweep -= 360.0;
        var centre = new Point2D(isBelow ? -One(10) : One(10), One(20));
        var (from, way) = isBelow ? (180.0 - start, -sweep) : (start, sweep);
        var parts = (int)Math.Ceiling(sweep / 90.0);
        return Enumerable.Range(0, parts).Select(i => Segment.FromArc(new ArcSegment(centre, radius, Angle.FromDegrees(from + (way * i / parts)), Angle.FromDegrees(way / parts))));
    }

    private double One(int code) => All(code) is [var value] ? value : throw new FormatException(code.ToString(CultureInfo.InvariantCulture));

    private double Maybe(int code, double otherwise) => All(code) is { Length: > 0 } values ? values[0] : otherwise;

    private double[] All(int code) => [.. _pairs.Where(pair => pair.Code == code).Select(Parse)];

    private static double Parse((int Code, string Value) pair) =>
        double.TryParse(pair.Value, NumberStyles.Float, CultureInfo.InvariantCulture, out var value) && Math.Abs(value) < 1e12 ? value : throw new FormatException(pair.Code.ToString(CultureInfo.InvariantCulture));
}
