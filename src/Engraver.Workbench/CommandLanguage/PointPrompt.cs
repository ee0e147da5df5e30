using System.Globalization;
using Engraver.Core.Geometry;

namespace Engraver.Workbench.CommandLanguage;

/// <summary>Asks for a point in drawing units: <c>x,y</c>, <c>#x,y</c>, <c>@dx,dy</c>, <c>dist&lt;angle</c>, <c>@dist&lt;angle</c>, <c>@</c> (the last
/// point). Angles in degrees, counter-clockwise from +X.</summary>
public sealed record PointPrompt(string Instruction) : ValuePrompt<Point2D>(Instruction)
{
    /// <summary>What the point is for.</summary>
    public PointUse Use { get; init; }

    /// <summary>Where the line to the point begins, or the first corner, drawing units; null without such a point.</summary>
    public Point2D? From { get; init; }

    /// <summary>Preview for a cursor position (<see cref="PointAim.Ghost"/>).</summary>
    public GhostOf? Ghost { get; init; }

    /// <summary>The picked object is removed from the selection (<see cref="PointAim.Removes"/>).</summary>
    public bool Removes { get; init; }

    public override PointAim Aim => new(Use, From) { Ghost = Ghost, Removes = Removes };

    public override Reading<Point2D> Read(string typed, Point2D lastPoint)
    {
        ArgumentNullException.ThrowIfNull(typed);
        var relative = typed[0] == '@';
        var body = typed[0] is '@' or '#' ? typed[1..] : typed;
        if (relative && body.Length == 0) return new Reading<Point2D>.Value(lastPoint);
        if (Coordinates(body) is not { } vector) return new Reading<Point2D>.Wrong(Wording.Get("PointPrompt.InvalidPoint", typed));
        var point = relative ? lastPoint + vector : Point2D.Origin + vector;
        return point.IsFinite ? new Reading<Point2D>.Value(point) : new Reading<Point2D>.Wrong(Wording.Get("PointPrompt.OutOfRange"));
    }

    private static Vector2D? Coordinates(string body)
    {
        var cartesian = body.Split(',');
        if (cartesian.Length == 2 && NumberPrompt.TryNumber(cartesian[0], out var x) && NumberPrompt.TryNumber(cartesian[1], out var y)) return new Vector2D(x, y);
        var polar = body.Split('<');
        return polar.Length == 2 && NumberPrompt.TryNumber(polar[0], out var distance) && NumberPrompt.TryNumber(polar[1], out var degrees)
            ? Vector2D.FromPolar(distance, Angle.FromDegrees(degrees))
            : null;
    }

    /// <summary>A point as displayed, in the form that can be typed.</summary>
    public static string Show(Point2D point) => string.Create(CultureInfo.InvariantCulture, $"{point.X:0.######},{point.Y:0.######}");
}

/// <summary>The preview of a command for a cursor position, drawing units; may be empty. Called while the cursor moves, on any thread, and must not change
/// state.</summary>
public delegate IReadOnlyList<Segment> GhostOf(Point2D place);

/// <summary>A request for a point of the drawing.</summary>
/// <param name="From">Start of the line to the point, or the first corner, drawing units; null without such a point.</param>
public sealed record PointAim(PointUse Use, Point2D? From)
{
    /// <summary>Preview of a click at a position; null without a preview.</summary>
    public GhostOf? Ghost { get; init; }

    /// <summary>The picked object is removed from the selection.</summary>
    public bool Removes { get; init; }

    /// <summary>Prefix of the coordinates of a click with Shift; null when Shift has no meaning.</summary>
    public string? ShiftMark { get; init; }

    /// <summary>A point without a base point.</summary>
    public static PointAim Place { get; } = new(PointUse.Place, null);

    /// <summary>The first corner of a box.</summary>
    public static PointAim FirstCorner { get; } = new(PointUse.Corner, null);
}

/// <summary>Purpose of a requested point. It determines the aids of the canvas.</summary>
public enum PointUse
{
    /// <summary>An exact point: object snap, snap grid and ORTHO apply.</summary>
    Place,

    /// <summary>A corner of a box: no snapping, because the corner is beside the objects in the box.</summary>
    Corner,

    /// <summary>The object at the point: no snapping.</summary>
    Object,
}
