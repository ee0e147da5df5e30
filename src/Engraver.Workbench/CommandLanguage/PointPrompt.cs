using System.Globalization;
using Engraver.Core.Geometry;

namespace Engraver.Workbench.CommandLanguage;

/// <summary>Asks for a point in drawing units: <c>x,y</c>, <c>#x,y</c>, <c>@dx,dy</c>, <c>dist&lt;angle</c>, <c>@dist&lt;angle</c>, <c>@</c> (the last
/// point). Angles in degrees, counter-clockwise from +X.</summary>
public sealed record PointPrompt(string Instruction) : ValuePrompt<Point2D>(Instruction)
{
    /// <summary>What the point is for.</summary>
    public PointPurpose Purpose { get; init; }

    /// <summary>Where the line to the point begins, or the first corner, drawing units; null without such a point.</summary>
    public Point2D? From { get; init; }

    /// <summary>Preview for a cursor position (<see cref="PointRequest.Ghost"/>).</summary>
    public GhostFunction? Ghost { get; init; }

    /// <summary>The picked object is removed from the selection (<see cref="PointRequest.IsDeselecting"/>).</summary>
    public bool IsDeselecting { get; init; }

    public override PointRequest PointRequest => new(Purpose, From) { Ghost = Ghost, IsDeselecting = IsDeselecting };

    public override ParsedInput<Point2D> Parse(string typed, Point2D lastPoint)
    {
        ArgumentNullException.ThrowIfNull(typed);
        var relative = typed[0] == '@';
        var body = typed[0] is '@' or '#' ? typed[1..] : typed;
        if (relative && body.Length == 0) return new ParsedInput<Point2D>.Value(lastPoint);
        if (Coordinates(body) is not { } vector) return new ParsedInput<Point2D>.Invalid(Wording.Get("PointPrompt.InvalidPoint", typed));
        var point = relative ? lastPoint + vector : Point2D.Origin + vector;
        return point.IsFinite ? new ParsedInput<Point2D>.Value(point) : new ParsedInput<Point2D>.Invalid(Wording.Get("PointPrompt.OutOfRange"));
    }

    private static Vector2D? Coordinates(string body)
    {
        var cartesian = body.Split(',');
        if (cartesian.Length == 2 && NumberPrompt.TryParse(cartesian[0], out var x) && NumberPrompt.TryParse(cartesian[1], out var y)) return new Vector2D(x, y);
        var polar = body.Split('<');
        return polar.Length == 2 && NumberPrompt.TryParse(polar[0], out var distance) && NumberPrompt.TryParse(polar[1], out var degrees)
            ? Vector2D.FromPolar(distance, Angle.FromDegrees(degrees))
            : null;
    }

    /// <summary>A point as displayed, in the form that can be typed.</summary>
    public static string Format(Point2D point) => string.Create(CultureInfo.InvariantCulture, $"{point.X:0.######},{point.Y:0.######}");
}
