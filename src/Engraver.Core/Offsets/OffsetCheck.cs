using Engraver.Core.Geometry;
using Engraver.Core.Offsets.Pieces;

namespace Engraver.Core.Offsets;

/// <summary>Measures the distance of an offset from what was drawn, ellipses and splines as they were drawn.</summary>
internal static class OffsetCheck
{
    /// <summary>Radius of the first search, in distances: nearly always the nearest piece lies at the distance.</summary>
    private const double NearEnough = 1.0001;

    /// <summary>Largest difference from the distance at the middles of all segments, millimetres; joins with a mitre or bevel have another distance and are not measured.</summary>
    public static double MaxDeviation(IReadOnlyList<OffsetContour> drawn, IReadOnlyList<OffsetLoop> loops, double distance, OffsetOptions options)
    {
        List<Segment> segments = [.. drawn.SelectMany(contour => contour.Segments)];
        var tree = new PieceTree([.. segments.Where(segment => !segment.IsFreeCurve && segment.Length > 0.0).Select(segment => PathPiece.FromSegment(segment))]);
        List<RationalCurve> curves = [.. segments.Where(segment => segment.IsFreeCurve).Select(segment => segment.Curve)];
        var boxes = curves.Count == 0 ? null : BoxTree.Build([.. curves.Select(curve => curve.Bounds)]);
        var largest = 0.0;
        foreach (var found in loops.SelectMany(loop => loop.Segments))
        {
            var place = found.PointAt(0.5);
            var nearest = tree.Nearest(place, distance * NearEnough);
            if (nearest >= distance * NearEnough) nearest = tree.Nearest(place, double.PositiveInfinity);
            boxes?.Nearest(place, (curve, from) => curves[curve].DistanceTo(from), nearest, out nearest);
            var deviation = Math.Abs(nearest - distance);
            if (options.Join == OffsetJoin.Round || deviation < distance * 1e-3) largest = Math.Max(largest, deviation);
        }

        return largest;
    }
}
