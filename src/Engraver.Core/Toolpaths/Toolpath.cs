using Engraver.Core.Geometry;

namespace Engraver.Core.Toolpaths;

/// <summary>Ordered strokes in millimetres, machine-neutral. Between strokes the tool is up and travels straight to the next start.</summary>
/// <param name="ToolStart">Where the tool stands when the job starts (drawing point, millimetres).</param>
/// <param name="Strokes">In the order of cutting; may be empty.</param>
public sealed record Toolpath(Point2D ToolStart, IReadOnlyList<ToolpathStroke> Strokes);
