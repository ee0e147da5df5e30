using Engraver.Core.Geometry;

namespace Engraver.Core.Toolpaths;

/// <summary>Ordered strokes in millimetres, machine-neutral. Between strokes the tool is off and moves straight to the next start.</summary>
/// <param name="ToolStart">Position of the tool when the job starts (drawing point, millimetres).</param>
/// <param name="Strokes">Strokes in the order of cutting; may be empty.</param>
public sealed record Toolpath(Point2D ToolStart, IReadOnlyList<ToolpathStroke> Strokes);
