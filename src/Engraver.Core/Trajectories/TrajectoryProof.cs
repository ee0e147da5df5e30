using Engraver.Core.Geometry;

namespace Engraver.Core.Trajectories;

/// <summary>Proves the bound of points from another source (a file), so that every bound is proven.</summary>
public static class TrajectoryProof
{
    /// <summary>Fraction of the length by which ends may differ from those of the source.</summary>
    private const double EndShare = 1e-12;

    /// <param name="lines">Points as in <see cref="Trajectory.Lines"/>.</param>
    /// <param name="knots">Knots as in <see cref="Trajectory.Knots"/>.</param>
    /// <param name="source">Segments, at least one with a length, joined end to start.</param>
    /// <param name="closed">True when the last segment ends where the first starts.</param>
    /// <param name="heights">Heights as in <see cref="Trajectory.Heights"/>; every such source consists of lines and arcs.</param>
    /// <returns>Null when the arguments do not match, or no bound can be proven.</returns>
    public static Trajectory? Prove(IReadOnlyList<Point2D> lines, IReadOnlyList<double> knots, IReadOnlyList<Segment> source, bool closed, IReadOnlyList<double>? heights = null)
    {
        ArgumentNullException.ThrowIfNull(lines);
        ArgumentNullException.ThrowIfNull(knots);
        ArgumentNullException.ThrowIfNull(source);
        if (lines.Count < 4 || knots.Count != lines.Count - 2 || (heights is not null && heights.Count != lines.Count) || !source.Any(segment => segment.Length > 0.0)) return null;
        var chain = SmoothChain.From(source, closed);
        for (var i = 1; i < knots.Count; i++) if (!(knots[i] > knots[i - 1])) return null;
        var (first, round) = (closed ? knots[0] : 0.0, EndShare * chain.Length);
        if (knots[0] < 0.0 || knots[0] > chain.Length || Math.Abs(knots[0] - first) > round || Math.Abs(knots[^1] - first - chain.Length) > round) return null;
        var spline = new CatmullRomSpline([.. lines]);
        List<double> exact = [first, .. knots.Skip(1).SkipLast(1), first + chain.Length];
        var bound = heights is null ? SplineBound.Measure(spline, chain, exact) : SpaceBound.Measure(spline, heights, chain, exact);
        if (!double.IsFinite(bound)) return null;
        return Describe(new SplineCandidate(spline, bound, exact), chain, source) with { Z = heights is null ? 0.0 : heights[1], Heights = heights };
    }

    /// <summary>The trajectory of points with their bound, at height 0.</summary>
    internal static Trajectory Describe(in SplineCandidate candidate, SmoothChain chain, IReadOnlyList<Segment> source)
    {
        var spline = candidate.Spline;
        return new Trajectory
        {
            Lines = spline.Lines,
            Knots = candidate.Knots,
            Source = source,
            Closed = chain.Closed,
            SampledError = SampledDistance.Of(spline.Count, i => spline[i], chain, candidate.Knots),
            VerifiedBound = candidate.Bound,
            SpacingRatio = spline.SpacingRatio(chain.Closed),
            Length = chain.Length,
        };
    }
}
