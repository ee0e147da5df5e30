using Engraver.Core.Geometry;

namespace Engraver.Core.Operations;

/// <summary>Where the strokes of an operation have what can be picked, millimetres.</summary>
/// <param name="Operation">Id of the operation.</param>
/// <param name="Tabs">Middles of the tabs on the path of the tool.</param>
/// <param name="UnusedStarts">Picked starts that no contour uses.</param>
public sealed record DressedPlaces(string Operation, IReadOnlyList<Point2D> Tabs, IReadOnlyList<Point2D> UnusedStarts);
