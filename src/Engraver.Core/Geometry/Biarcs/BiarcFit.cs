namespace Engraver.Core.Geometry.Biarcs;

/// <summary>Approximates ellipses and splines by arcs and lines: pairs of arcs that take ends and end directions from the curve, so that the path has corners
/// only where the curve has them.</summary>
/// <remarks>Each pair is as long as the tolerance allows, found by galloping and bisection from the end of the last. A part of what fits also fits, so taking
/// the longest gives the fewest (for nearly all curves).</remarks>
public static class BiarcFit
{
    /// <summary>Finest tolerance as a part of the curve's size and distance from the origin; below it rounding dominates, and a curve of kilometres would
    /// become a million arcs.</summary>
    private const double FinestOfSize = 1e-9;

    private const double FinestOfPlace = 1e-13;

    /// <summary>Up to this number of arcs a second search for one arc fewer is made.</summary>
    private const int FewArcs = 64;

    /// <summary>Arcs and lines that begin and end where the curve does. No point of them is farther than <paramref name="maxError"/> from the curve, nor any
    /// point of the curve from them (proved by bounds, not by samples).</summary>
    /// <param name="curve">The curve.</param>
    /// <param name="maxError">Millimetres (or the curve's unit), above 0; raised to 1e-9 of the curve's size.</param>
    /// <returns>At least one segment. Within a smooth run neighbours share their tangent; only at a cusp inside a span a line shorter than the tolerance
    /// bridges it.</returns>
    public static IReadOnlyList<Segment> Fit(RationalCurve curve, double maxError)
    {
        var box = curve.Bounds;
        var place = Math.Max(Math.Max(Math.Abs(box.MinX), Math.Abs(box.MaxX)), Math.Max(Math.Abs(box.MinY), Math.Abs(box.MaxY)));
        var tolerance = Math.Max(maxError, Math.Max(FinestOfSize * (box.Width + box.Height), FinestOfPlace * place));
        var chain = new ArcChain();
        foreach (var run in SmoothRun.Split(curve))
        {
            foreach (var arc in Cover(run, tolerance, EndDirection(curve, run))) chain.Add(arc);
        }

        var segments = chain.ToSegments();
        return segments.Count > 0 ? segments : [Segment.FromLine(curve.Start, curve.End)];
    }

    /// <summary>A contour with its ellipses and splines replaced by arcs and lines as above; lines and arcs remain as given.</summary>
    /// <param name="contour">Any segments.</param>
    /// <param name="maxError">As above, for each curve.</param>
    public static IReadOnlyList<Segment> FitContour(IEnumerable<Segment> contour, double maxError)
    {
        var segments = new List<Segment>();
        foreach (var segment in contour)
        {
            if (segment.IsFreeCurve) segments.AddRange(Fit(segment.Curve, maxError));
            else segments.Add(segment);
        }

        return segments;
    }

    /// <summary>Sine by which the last arc may differ from the curve's end direction: at the end of a spline that closes without a corner, up to the limit of a
    /// corner.</summary>
    private static double EndDirection(RationalCurve curve, SmoothRun run) =>
        curve is { Kind: SegmentKind.Spline, IsClosed: true } && run.End == curve.Spans.Length ? SmoothRun.CornerSine : BiarcChoice.SameDirection;

    /// <summary>The fewest arcs of several searches: from the front, from the back (the longest-first rule may leave a very short last arc in one direction
    /// only), and from span to span where spans are similar to arcs.</summary>
    private static IReadOnlyList<TangentArc> Cover(SmoothRun run, double tolerance, double endDirection)
    {
        var forwards = new BiarcSearch(run, tolerance).Cover();
        if (forwards.Count <= 1 || forwards.Count > FewArcs) return forwards;
        var backwards = new BiarcSearch(run.Reversed(), tolerance).Cover();
        var fewer = backwards.Count < forwards.Count ? [.. backwards.Reverse().Select(arc => arc.Reversed())] : forwards;
        return new SpanArcs(run, tolerance, endDirection).Cover() is { } arcs && arcs.Count < fewer.Count ? arcs : fewer;
    }
}
