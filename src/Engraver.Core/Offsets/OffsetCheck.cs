using Engraver.Core.Geometry;
using Engraver.Core.Offsets.Pieces;

namespace Engraver.Core.Offsets;

/// <summary>Measures the distance of an offset from the drawn contours, with ellipses and splines as drawn.</summary>
internal static class OffsetCheck
{
    /// <summary>Radius of the first search, in distances: the nearest piece is almost always at the distance.</summary>
    private const double NearEnough = 1.0001;

    /// <summary>Maximum number of segments that are measured, evenly spread.</summary>
    private const int MaxMeasured = 20_000;

    /// <summary>Largest difference from the distance, millimetres, at the middle of each segment or of the part that is next to its source; mitres and bevels
    /// have a different distance and are not measured.</summary>
    /// <remarks>A loop is compared with its sources: in and out of closed contours with all of these together, left and right only with its own
    /// contour.</remarks>
    public static double MaxDeviation(IReadOnlyList<OffsetContour> drawn, IReadOnlyList<OffsetLoop> loops, double distance, OffsetSide side, OffsetOptions options)
    {
        var step = 1 + (loops.Sum(loop => loop.Segments.Count) / MaxMeasured);
        return loops.GroupBy(loop => OwnContourOf(loop, drawn, side)).Select(together =>
            Largest(drawn, together.Key < 0 ? [.. drawn.Where(contour => contour.Closed)] : [drawn[together.Key]], together, distance, step, options)).DefaultIfEmpty().Max();
    }

    /// <summary>The single source contour of a loop; -1 when all closed contours contributed.</summary>
    private static int OwnContourOf(OffsetLoop loop, IReadOnlyList<OffsetContour> drawn, OffsetSide side)
    {
        var source = loop.Sources[0].Contour;
        return drawn[source].Closed && side is not (OffsetSide.Left or OffsetSide.Right) ? -1 : source;
    }

    private static double Largest(IReadOnlyList<OffsetContour> drawn, IReadOnlyList<OffsetContour> against, IEnumerable<OffsetLoop> loops, double distance, int step, OffsetOptions options)
    {
        List<Segment> segments = [.. against.SelectMany(contour => contour.Segments)];
        var tree = new PieceTree([.. segments.Where(segment => !segment.IsFreeCurve && segment.Length > 0.0).Select(segment => PathPiece.FromSegment(segment))]);
        List<RationalCurve> curves = [.. segments.Where(segment => segment.IsFreeCurve).Select(segment => segment.Curve)];
        var boxes = curves.Count == 0 ? null : BoxTree.Build([.. curves.Select(curve => curve.Bounds)]);
        var largest = 0.0;
        foreach (var (place, own) in Places(drawn, loops, step, options.Join == OffsetJoin.Round))
        {
            var nearest = options.Join == OffsetJoin.Bevel ? DistanceTo(own, place) : Nearest(place); // a bevelled corner may be nearer
            largest = Math.Max(largest, Math.Abs(nearest - distance));
        }

        return largest;

        double Nearest(Point2D place)
        {
            var nearest = tree.Nearest(place, distance * NearEnough);
            if (nearest >= distance * NearEnough) nearest = tree.Nearest(place, double.PositiveInfinity);
            boxes?.Nearest(place, (curve, from) => curves[curve].DistanceTo(from), nearest, out nearest);
            return nearest;
        }
    }

    private static double DistanceTo(in Segment segment, Point2D place) => segment.IsFreeCurve ? segment.Curve.DistanceTo(place) : PathPiece.FromSegment(segment).DistanceTo(place);

    private static IEnumerable<(Point2D Place, Segment Own)> Places(IReadOnlyList<OffsetContour> drawn, IEnumerable<OffsetLoop> loops, int step, bool joinsAreRound)
    {
        var number = 0;
        foreach (var loop in loops)
        {
            for (var i = 0; i < loop.Segments.Count; i++)
            {
                if (number++ % step != 0) continue;
                var own = drawn[loop.Sources[i].Contour].Segments[loop.Sources[i].Segment];
                if (joinsAreRound) yield return (loop.Segments[i].PointAt(0.5), own);
                else if (!loop.Sources[i].IsJoin && Beside(loop.Segments[i], own) is { } place) yield return (place, own);
            }
        }
    }

    /// <summary>The middle of the part next to the source: a mitre lengthens lines beyond it. Null when there is no such part, or when the source is a curve
    /// that the line approximates in part.</summary>
    private static Point2D? Beside(in Segment found, in Segment source)
    {
        if (found.Kind != SegmentKind.Line) return found.PointAt(0.5);
        if (source.Kind != SegmentKind.Line) return null;
        var (way, length) = (found.End - found.Start, found.Length * found.Length);
        var (one, other) = ((source.Start - found.Start).Dot(way) / length, (source.End - found.Start).Dot(way) / length);
        var (from, to) = (Math.Max(0.0, Math.Min(one, other)), Math.Min(1.0, Math.Max(one, other)));
        return from < to ? found.Start + (way * ((from + to) / 2.0)) : null;
    }
}
