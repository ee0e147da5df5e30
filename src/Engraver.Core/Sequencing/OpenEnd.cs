using Engraver.Core.Geometry;

namespace Engraver.Core.Sequencing;

/// <summary>A discontinuity in the operator's terms: where, which entity, how far to the nearest other open end, and under which diagnostic it is reported.</summary>
/// <param name="Place">Millimetres.</param>
/// <param name="EntityIndex">The drawing entity that ends here.</param>
/// <param name="Gap">Distance to the nearest other open end; null without one.</param>
/// <param name="NearestEntityIndex">The entity of that other end; -1 without one.</param>
/// <param name="NearestHandle">Its handle; null without one or when the drawing has none.</param>
/// <param name="DiagnosticId">SEQ0003 when the gap is suspiciously small, SEQ0002 otherwise.</param>
public sealed record OpenEnd(Point2D Place, int EntityIndex, double? Gap, int NearestEntityIndex, string? NearestHandle, string DiagnosticId);
