
namespace Engraver.Core.Kerf;

/// <summary>A place of the drawing that the tool does not reach.</summary>
/// <param name="Place">Point with the largest distance, millimetres.</param>
/// <param name="Uncut">Largest distance of the drawn line from the area that the tool reaches, millimetres.</param>
/// <param name="Entity">Drawing entity at that point.</param>
/// <param name="IsWhole">No part of the contour is reached.</param>
public sealed record UncutPlace(Geometry.Point2D Place, double Uncut, int Entity, bool IsWhole);
