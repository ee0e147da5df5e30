using Engraver.Core.Drawings;
using Engraver.Core.Geometry;

namespace Engraver.App.Canvas;

/// <summary>Current and recent positions of the machine. Equal while the machine is at rest.</summary>
/// <param name="At">Current machine position in machine coordinates, millimetres.</param>
/// <param name="Trail">Recent machine positions in machine coordinates, millimetres; the newest is the last.</param>
/// <param name="Zero">From the machine zero to the zero of the drawing, millimetres.</param>
/// <param name="Scale">Of the drawing that is open.</param>
/// <param name="Note">Why the position in the drawing is uncertain, and what to do; empty if it is certain.</param>
public sealed record MachineMark(Point2D At, IReadOnlyList<Point2D> Trail, Vector2D Zero, DrawingScale Scale, string Note)
{
    /// <summary>Current machine position, drawing units.</summary>
    public Point2D Place => InDrawing(At);

    public bool IsCertain => Note.Length == 0;

    /// <summary>Converts a machine position to drawing units.</summary>
    public Point2D InDrawing(Point2D place) => Scale.ToDrawing(place - Zero);
}
