using Engraver.Core.Geometry;
using Engraver.Core.Offsets;

namespace Engraver.Core.Operations;

/// <summary>Lines of a fill that are parallel to the contours: contours at the inset, and at every multiple of the spacing from it.</summary>
/// <param name="Distance">From the drawn contours, mm.</param>
/// <param name="Segments">In order; each ends where the next one begins.</param>
internal sealed record FillContour(double Distance, IReadOnlyList<Segment> Segments)
{
    /// <summary>Largest number of distances.</summary>
    public const int Most = 2000;

    /// <param name="closed">Closed contours; those that are inside others are islands.</param>
    /// <param name="inset">Distance of the first lines, above 0.</param>
    /// <param name="spacing">Above 0.</param>
    /// <param name="maxErrorMm">Largest distance of arcs from an ellipse or spline.</param>
    /// <param name="unresolved">Places where the contours could not be offset.</param>
    public static IReadOnlyList<FillContour> Of(IReadOnlyList<OffsetContour> closed, double inset, double spacing, double maxErrorMm, out IReadOnlyList<Point2D> unresolved)
    {
        var (lines, failed) = (new List<FillContour>(), new List<Point2D>());
        for (var step = 0; step < Most; step++)
        {
            var distance = inset + (step * spacing);
            var loops = Loops(distance);
            if (loops.Count == 0) break;
            lines.AddRange(loops.Select(loop => new FillContour(distance, [.. loop.Where(segment => segment.Length > 0.0)])));
        }

        unresolved = failed;
        return lines;

        List<IReadOnlyList<Segment>> Loops(double distance)
        {
            var offset = ContourOffset.Offset(closed, distance, OffsetSide.In, OffsetOptions.Round(maxErrorMm));
            failed.AddRange(offset.Unresolved);
            return [.. offset.Loops.Select(loop => loop.Segments)];
        }
    }
}
