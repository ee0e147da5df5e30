using Engraver.Core.Geometry;

namespace Engraver.Core.Unions;

/// <summary>The outlines of the area that contours cover together.</summary>
/// <param name="Contours">Closed contours of lines, arcs and circles, the covered area on the left of each: outlines run counter-clockwise, holes clockwise.
/// Contours that touch in a point are separate. Where the union failed, the contours as given.</param>
/// <param name="Unresolved">Places at which no closed outline was found, or a given contour is not closed; empty when the union is complete.</param>
public sealed record UnionResult(IReadOnlyList<IReadOnlyList<Segment>> Contours, IReadOnlyList<Point2D> Unresolved)
{
    public bool IsComplete => Unresolved.Count == 0;
}
