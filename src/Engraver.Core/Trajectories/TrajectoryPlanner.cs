using Engraver.Core.Geometry;

namespace Engraver.Core.Trajectories;

/// <summary>Converts contours to trajectories with the fewest points found for which the proven bound is within the error (sace-xps-agie.md 3.5).</summary>
public static class TrajectoryPlanner
{
    /// <summary>Points nearer to each other than this are the same.</summary>
    private const double MinLength = 1e-8;

    /// <summary>One trajectory for each run between two corners, or one for the contour (<see cref="TrajectoryOptions.Corners"/>).</summary>
    /// <param name="contour">Lines, arcs, circles, ellipses and splines joined end to start, millimetres; gaps are bridged by lines.</param>
    /// <param name="closed">True when the last segment ends where the first starts.</param>
    public static TrajectoryResult Plan(IReadOnlyList<Segment> contour, bool closed, TrajectoryOptions options)
    {
        ArgumentNullException.ThrowIfNull(contour);
        ArgumentNullException.ThrowIfNull(options);
        ArgumentOutOfRangeException.ThrowIfNegativeOrZero(options.MaxError);
        if (options.SegmentLength is { } step) ArgumentOutOfRangeException.ThrowIfNegativeOrZero(step, nameof(options));
        var (done, failed) = (new List<Trajectory>(), new List<IReadOnlyList<Segment>>());
        foreach (var (segments, isRound) in ContourRuns.Split(contour, closed, options.Corners, options.MaxError))
        {
            if (segments.Sum(segment => segment.Length) < MinLength) continue;
            if (One(SmoothChain.From(segments, isRound), segments, options) is { } trajectory) done.Add(trajectory);
            else failed.Add(segments);
        }

        return new TrajectoryResult(done, failed);
    }

    private static Trajectory? One(SmoothChain chain, IReadOnlyList<Segment> segments, TrajectoryOptions options)
    {
        var found = options.SegmentLength is { } step ? Evenly(chain, step) : new SpacingSearch(chain, options.MaxError).Find();
        return found is { } candidate ? TrajectoryProof.Describe(candidate, chain, segments) with { Z = options.Z } : null;
    }

    private static SplineCandidate? Evenly(SmoothChain chain, double step)
    {
        var profile = new SpacingProfile(chain);
        profile.FillEvenly(step);
        var knots = KnotPlacement.Place(chain, profile);
        var fit = new SplineFit(chain, knots);
        var bound = SplineBound.Measure(fit.Spline, chain, knots);
        return double.IsFinite(bound) ? new SplineCandidate(fit.Spline, bound, knots) : null;
    }
}

/// <summary>The result for a contour.</summary>
/// <param name="Trajectories">Trajectories in the order of travel.</param>
/// <param name="Unproven">Runs for which no spline could be proven to be within the error, for example at a cusp inside a curve.</param>
public sealed record TrajectoryResult(IReadOnlyList<Trajectory> Trajectories, IReadOnlyList<IReadOnlyList<Segment>> Unproven);
