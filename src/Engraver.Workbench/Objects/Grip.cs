using Engraver.Core.Geometry;

namespace Engraver.Workbench.Objects;

/// <summary>A point by which an object can be dragged.</summary>
/// <param name="Entity">Index into the drawing's entities.</param>
/// <param name="Part">Index into the drawing's parts.</param>
/// <param name="Kind">Effect of dragging it.</param>
/// <param name="Place">Drawing units.</param>
public readonly record struct Grip(int Entity, int Part, GripKind Kind, Point2D Place);
