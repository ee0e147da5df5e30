using Engraver.Core.Geometry;

namespace Engraver.Core.Posts.Agie;

/// <summary>One block of an AGIECUT DEM15 program: a line by its increments or an arc by whole degrees (paper 000, Table 1; sace-xps-agie.md 4.1). Lengths are
/// micrometres.</summary>
/// <param name="StartDegrees">Direction from the centre to the start, 0 to 359, counter-clockwise from X; 0 for a line.</param>
/// <param name="WorkDegrees">Degrees that are swept, 1 to 359, in either direction; 0 for a line.</param>
/// <param name="X">X increment of a line, radius of an arc.</param>
/// <param name="Y">Y increment of a line, radius of an arc.</param>
/// <param name="Cutting">False: positioning.</param>
public readonly record struct AgieBlock(AgieMotion Motion, int StartDegrees, int WorkDegrees, int X, int Y, bool Cutting)
{
    /// <summary>Largest increment or radius that six digits hold.</summary>
    public const int Largest = 999_999;

    public static AgieBlock Line(int x, int y, bool cutting) => new(AgieMotion.Line, 0, 0, x, y, cutting);

    public static AgieBlock Arc(bool clockwise, int startDegrees, int workDegrees, int radius) =>
        new(clockwise ? AgieMotion.Clockwise : AgieMotion.CounterClockwise, ((startDegrees % 360) + 360) % 360, workDegrees, radius, radius, Cutting: true);

    /// <summary>End of the block from a given start, micrometres: the end of an arc follows from its radius and its whole degrees.</summary>
    public Segment PathFrom(Point2D place)
    {
        if (Motion == AgieMotion.Line) return Segment.FromLine(place, place + new Vector2D(X, Y));
        var start = Angle.FromDegrees(StartDegrees);
        return Segment.FromArc(new ArcSegment(place - Vector2D.FromPolar(X, start), X, start, Angle.FromDegrees(Motion == AgieMotion.Clockwise ? -WorkDegrees : WorkDegrees)));
    }
}

/// <summary>Field 2 of a block.</summary>
public enum AgieMotion
{
    Line = 1,
    Clockwise = 2,
    CounterClockwise = 3,
}

/// <summary>A block with the part of the path that it represents.</summary>
/// <param name="Drawn">The line or arc of the path, millimetres; null for positioning.</param>
/// <param name="Stroke">Place in the order of cutting of the stroke that it cuts or precedes.</param>
/// <param name="Move">Index of the move in the stroke; -1 for positioning.</param>
public readonly record struct AgieStep(AgieBlock Block, Segment? Drawn, int Stroke, int Move);
