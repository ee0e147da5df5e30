using System.Diagnostics;
using System.Globalization;
using Engraver.Core.Geometry;

namespace Engraver.Core.Posts.ClDataReading;

/// <summary>The pairs of one DXF entity as CL data has them, and the path along it. Only entities parallel to the plane of the drawing, seen from above or from
/// below.</summary>
/// <param name="Type">LINE, ARC, CIRCLE, ELLIPSE or SPLINE.</param>
/// <param name="Line">Line of the file, from 1.</param>
internal sealed record ClDataEntity(string Type, int Line)
{
    /// <summary>Largest angle from the start of an arc to its end, degrees: a hundred turns.</summary>
    private const double MaxDegrees = 36_000.0;

    private readonly List<(int Code, string Value)> _pairs = [];

    public string Layer => _pairs.Where(pair => pair.Code == 8).Select(pair => pair.Value.Trim()).FirstOrDefault() ?? "";

    /// <summary>The first height that is not 0, as written; null when the whole entity is in the plane.</summary>
    public string? Height => _pairs.Where(pair => pair.Code is 30 or 31 or 38 or 39 && !(double.TryParse(pair.Value, NumberStyles.Float, CultureInfo.InvariantCulture, out var height) && height == 0.0)).Select(pair => pair.Value.Trim()).FirstOrDefault();

    public void Add(int code, string value) => _pairs.Add((code, value));

    /// <summary>Lines and arcs, in the direction of travel; null when a number is missing, duplicate or invalid, with the reason.</summary>
    public IEnumerable<Segment>? Path(out string reason)
    {
        var numbers = new GroupNumbers(_pairs);
        var isHidden = numbers.IsAnySet(60, 67);
        var isTilted = !isHidden && (numbers.Optional(210, 0.0) != 0.0 || numbers.Optional(220, 0.0) != 0.0 || Math.Abs(numbers.Optional(230, 1.0)) != 1.0);
        var path = numbers.Invalid is null && !isHidden && !isTilted ? Path(numbers) : null;
        if (numbers.Invalid is { } code) reason = Wording.Get("ClDataReader.BadGroupValue", code.ToString(CultureInfo.InvariantCulture));
        else reason = isHidden ? Wording.Get("ClDataReader.HiddenOrOnPaper") : isTilted ? Wording.Get("ClDataReader.Tilted") : "";
        return reason.Length == 0 ? path : null;
    }

    private IEnumerable<Segment>? Path(GroupNumbers numbers) => Type switch
    {
        "LINE" => LineOf(numbers),
        "ARC" => ArcOf(numbers, numbers.Single(50), numbers.Single(51)),
        "CIRCLE" => ArcOf(numbers, numbers.Optional(1040, 0.0), numbers.Optional(1040, 0.0) + 360.0), // its start is in the extended data
        "ELLIPSE" => ClDataCurves.Ellipse(numbers),
        "SPLINE" => ClDataCurves.Spline(numbers),
        _ => throw new UnreachableException(Type),
    };

    private static IEnumerable<Segment>? LineOf(GroupNumbers numbers)
    {
        var (start, end) = (new Point2D(numbers.Single(10), numbers.Single(20)), new Point2D(numbers.Single(11), numbers.Single(21)));
        return numbers.Invalid is null ? [Segment.FromLine(start, end)] : null;
    }

    /// <summary>Counter-clockwise in the entity's own system, which is mirrored in x when it is seen from below. In quarters of a turn at most, as the judges
    /// require arcs.</summary>
    private static IEnumerable<Segment>? ArcOf(GroupNumbers numbers, double start, double end)
    {
        var (isBelow, radius, sweep) = (numbers.Optional(230, 1.0) < 0.0, numbers.Single(40), end - start);
        if (!(radius > 0.0)) numbers.Reject(40);
        if (Math.Abs(sweep) > MaxDegrees) numbers.Reject(50);
        var (x, y) = (numbers.Single(10), numbers.Single(20));
        if (numbers.Invalid is not null) return null;
        while (sweep <= 0.0) sweep += 360.0;
        while (sweep > 360.0) sweep -= 360.0;
        var centre = new Point2D(isBelow ? -x : x, y);
        var (from, way) = isBelow ? (180.0 - start, -sweep) : (start, sweep);
        var parts = (int)Math.Ceiling(sweep / 90.0);
        return Enumerable.Range(0, parts).Select(i => Segment.FromArc(new ArcSegment(centre, radius, Angle.FromDegrees(from + (way * i / parts)), Angle.FromDegrees(way / parts))));
    }
}
