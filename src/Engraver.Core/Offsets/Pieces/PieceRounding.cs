using Engraver.Core.Geometry;

namespace Engraver.Core.Offsets.Pieces;

/// <summary>Length by which computed points of lines and arcs can be wrong because of rounding.</summary>
internal static class PieceRounding
{
    /// <summary>The share of the size of the coordinates.</summary>
    private const double OfSize = 1e-14;

    /// <summary>The share of the largest radius: the rounding of a distance from its centre.</summary>
    private const double OfRadius = 3e-16;

    /// <param name="extent">Largest coordinate.</param>
    /// <param name="segments">The segments; radii of ellipses and splines do not count.</param>
    public static double Of(double extent, IEnumerable<Segment> segments)
    {
        var largest = 0.0;
        foreach (var segment in segments)
        {
            if (segment.Kind is SegmentKind.Arc or SegmentKind.Circle) largest = Math.Max(largest, PathPiece.FromSegment(segment).Radius);
        }

        return (OfSize * extent) + (OfRadius * largest);
    }
}
