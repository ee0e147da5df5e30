using Engraver.Core.Geometry;

namespace Engraver.Core.Reshaping;

/// <summary>EXTEND: the extension of an open object to the next edge. A line is extended straight, an arc along its circle; an ellipse or spline is not
/// extended.</summary>
public static class PathExtension
{
    /// <summary>An edge at which the object already ends is not the next one: it is nearer than this fraction of the sizes and coordinates.</summary>
    private const double SamePlaceTolerance = 1e-9;

    /// <summary>The end that is nearer to a place, lengthened to the next edge.</summary>
    /// <param name="edges">The boundary edges.</param>
    /// <param name="lengthened">True when lines and arcs among the edges also extend beyond their ends.</param>
    /// <returns>The first or last part, which grows (fraction below 0 or above 1), and what is added to it; null when there is no edge ahead.</returns>
    public static (PathRange Grown, PathRange Added)? Find(EntityPath path, IEnumerable<Segment> edges, Point2D picked, bool lengthened = false)
    {
        ArgumentNullException.ThrowIfNull(path);
        ArgumentNullException.ThrowIfNull(edges);
        if (path.Closed) return null;
        var atStart = path.Parts[0].Start.DistanceTo(picked) < path.Parts[^1].End.DistanceTo(picked);
        var index = atStart ? 0 : path.Parts.Count - 1;
        var part = path.Parts[index];
        if (part.IsFreeCurve) return null;
        if (Next(atStart ? part.Reversed() : part, edges, lengthened) is not { } next) return null;
        return atStart
            ? (new PathRange(index, -next.Beyond, 1.0, next.At, part.End), new PathRange(index, -next.Beyond, 0.0, next.At, part.Start))
            : (new PathRange(index, 0.0, 1.0 + next.Beyond, part.Start, next.At), new PathRange(index, 1.0, 1.0 + next.Beyond, part.End, next.At));
    }

    /// <summary>The nearest edge beyond the end of a part; the distance is a fraction of its length.</summary>
    private static (double Beyond, Point2D At)? Next(Segment part, IEnumerable<Segment> edges, bool lengthened)
    {
        (double Beyond, Point2D At)? nearest = null;
        var slack = SamePlaceTolerance * (part.Length + Math.Abs(part.End.X) + Math.Abs(part.End.Y));
        foreach (var edge in edges)
        {
            foreach (var at in SegmentCrossings.Carriers(part, edge))
            {
                var beyond = Beyond(part, at);
                if (beyond * part.Length <= slack || at.DistanceTo(part.End) <= slack || beyond >= (nearest?.Beyond ?? double.PositiveInfinity)) continue;
                if (lengthened || SegmentCrossings.IsOn(edge, at)) nearest = (beyond, at);
            }
        }

        return nearest;
    }

    /// <summary>Distance of a place of the carrier beyond the end; for a circle, forwards around to the start.</summary>
    private static double Beyond(Segment part, Point2D at)
    {
        var fraction = PathPlace.FractionOf(part, at);
        if (part.Kind == SegmentKind.Line) return fraction - 1.0;
        var turn = 360.0 / part.Arc.Sweep.Abs().Degrees;
        return (fraction < 0.0 ? fraction + turn : fraction) - 1.0;
    }
}
