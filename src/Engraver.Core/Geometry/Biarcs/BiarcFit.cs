namespace Engraver.Core.Geometry.Biarcs;

/// <summary>Ellipses and splines as arcs and lines: pairs of arcs whose ends and end directions are the curve's, so that nothing but a corner of the curve becomes a corner of the path.</summary>
/// <remarks>Each pair is as long as the tolerance allows: found by galloping and bisection from where the last one ended. Since a part of what fits fits too, longest first is also fewest (but for curves that turn the rule round).</remarks>
public static class BiarcFit
{
    /// <summary>Of a curve's size and of its distance from the origin: no tolerance can be finer than this, or a curve of kilometres would become a million arcs.</summary>
    private const double FinestOfSize = 1e-9;

    private const double FinestOfPlace = 1e-13;

    /// <summary>Up to here a piece more or less is worth a second search.</summary>
    private const int FewArcs = 64;

    /// <summary>Arcs and lines that begin and end where the curve does and lie nowhere farther from it than <paramref name="maxError"/> (bounded, not sampled), nor it from them.</summary>
    /// <param name="curve">The curve.</param>
    /// <param name="maxError">Above 0; raised to 1e-9 of the curve's size.</param>
    /// <returns>At least one segment. Within a smooth run neighbours share their tangent; only where a cusp lies inside a span a line shorter than the tolerance bridges it.</returns>
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

    /// <summary>A spline that closes without a corner has no end whose direction could be missed by more than what is no corner.</summary>
    private static double EndDirection(RationalCurve curve, SmoothRun run) =>
        curve is { Kind: SegmentKind.Spline, IsClosed: true } && run.End == curve.Spans.Length ? SmoothRun.CornerSine : BiarcChoice.SameDirection;

    /// <summary>From the front and from the back: greed that ends in a stub on the one way often does not on the other. Then, where the spans are like arcs, by arcs from span to span.</summary>
    private static IReadOnlyList<TangentArc> Cover(SmoothRun run, double tolerance, double endDirection)
    {
        var forwards = new BiarcSearch(run, tolerance).Cover();
        if (forwards.Count <= 1 || forwards.Count > FewArcs) return forwards;
        var backwards = new BiarcSearch(run.Reversed(), tolerance).Cover();
        var fewer = backwards.Count < forwards.Count ? [.. backwards.Reverse().Select(arc => arc.Reversed())] : forwards;
        return new SpanArcs(run, tolerance, endDirection).Cover() is { } arcs && arcs.Count < fewer.Count ? arcs : fewer;
    }
}
