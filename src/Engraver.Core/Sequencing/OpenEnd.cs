using Engraver.Core.Geometry;

namespace Engraver.Core.Sequencing;

/// <summary>A discontinuity in the operator's terms: its place, its entity, the distance to the nearest other open end, and its diagnostic.</summary>
/// <param name="Place">Position, millimetres.</param>
/// <param name="EntityIndex">The drawing entity that ends here.</param>
/// <param name="Gap">Distance to the nearest other open end; null without one.</param>
/// <param name="NearestEntityIndex">The entity of that other end; -1 without one.</param>
/// <param name="NearestHandle">Handle of the nearest entity; null without one or when the drawing has none.</param>
/// <param name="DiagnosticId">SEQ0003 when the gap is suspiciously small and wider than the join tolerance, SEQ0002 otherwise.</param>
public sealed record OpenEnd(Point2D Place, int EntityIndex, double? Gap, int NearestEntityIndex, string? NearestHandle, string DiagnosticId);
