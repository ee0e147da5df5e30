using System.Globalization;
using Engraver.Core.Geometry;

namespace Engraver.Workbench.CommandLanguage;

/// <summary>Asks for a point in drawing units: <c>x,y</c>, <c>#x,y</c>, <c>@dx,dy</c>, <c>dist&lt;angle</c>, <c>@dist&lt;angle</c>, <c>@</c> (the last
/// point). Angles in degrees, counter-clockwise from +X.</summary>
public sealed record PointPrompt(string Instruction) : ValuePrompt<Point2D>(Instruction)
{
    /// <summary>What the point is for.</summary>
    public PointUse Use { get; init; }

    /// <summary>Where the line to the point begins, or the first corner, drawing units; null when the point stands alone.</summary>
    public Point2D? From { get; init; }

    /// <summary>What a place would give (<see cref="PointAim.Ghost"/>).</summary>
    public GhostOf? Ghost { get; init; }

    /// <summary>What is pointed at is taken out of what was picked (<see cref="PointAim.Removes"/>).</summary>
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

    /// <summary>A point as it is shown and as it can be typed again.</summary>
    public static string Show(Point2D point) => string.Create(CultureInfo.InvariantCulture, $"{point.X:0.######},{point.Y:0.######}");
}

/// <summary>What a command would draw if this place were given, drawing units; empty for nothing. It is called while the cursor moves, on any thread, and
/// must not change anything.</summary>
public delegate IReadOnlyList<Segment> GhostOf(Point2D place);

/// <summary>A place of the drawing that is asked for.</summary>
/// <param name="From">Where the line to the place begins, or the first corner, drawing units; null when the place stands alone.</param>
public sealed record PointAim(PointUse Use, Point2D? From)
{
    /// <summary>What a click at a place would give, so that it can be seen before; null when there is nothing to be seen beforehand.</summary>
    public GhostOf? Ghost { get; init; }

    /// <summary>What is pointed at is taken out of what was picked.</summary>
    public bool Removes { get; init; }

    /// <summary>What stands before the coordinates of a click with Shift; null when Shift means nothing here.</summary>
    public string? ShiftMark { get; init; }

    /// <summary>A place that stands alone.</summary>
    public static PointAim Place { get; } = new(PointUse.Place, null);

    /// <summary>The corner where a box begins.</summary>
    public static PointAim FirstCorner { get; } = new(PointUse.Corner, null);
}

/// <summary>What a place of the drawing is asked for. It decides how the canvas helps to point at it.</summary>
public enum PointUse
{
    /// <summary>A place, exactly: object snaps, the snap raster and ORTHO help.</summary>
    Place,

    /// <summary>A corner of a box: nothing snaps, because the corner stands beside the objects that the box holds.</summary>
    Corner,

    /// <summary>The object at the place: nothing snaps.</summary>
    Object,
}
