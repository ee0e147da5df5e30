using Engraver.Core.Geometry;

namespace Engraver.Core.Trajectories;

/// <summary>The trajectory of a hole that is bored by a helix: full turns down to the depth, then one turn at the bottom.</summary>
/// <remarks>All steps turn by the same angle th. With m = (9 cos(th/2) - cos(3 th/2)) / 8 points at the radius R give an error of R (1 - m) to the inside in
/// the middle of a step; at 2 R / (1 + m) the error is on both sides (sace-xps-agie.md 3.4).</remarks>
public static class HelixPlanner
{
    private const int MinSteps = 8;

    private const int MaxSteps = 100_000;

    /// <summary>Maximum number of turns of one hole.</summary>
    public const int MaxTurns = 10_000;

    /// <param name="centre">Centre of the hole, millimetres.</param>
    /// <param name="radius">Radius of the tool centre path, above 0.</param>
    /// <param name="top">Height of the start.</param>
    /// <param name="depth">Depth below the top, above 0.</param>
    /// <param name="pitch">Largest descent per turn, above 0; it is reduced so that the number of turns is whole.</param>
    /// <param name="clockwise">True for clockwise as seen from above.</param>
    /// <param name="maxError">Largest distance in space from the helix, above 0.</param>
    /// <returns>Null when there would be too many turns or points.</returns>
    public static Trajectory? Plan(Point2D centre, double radius, double top, double depth, double pitch, bool clockwise, double maxError)
    {
        ArgumentOutOfRangeException.ThrowIfNegativeOrZero(radius);
        ArgumentOutOfRangeException.ThrowIfNegativeOrZero(depth);
        ArgumentOutOfRangeException.ThrowIfNegativeOrZero(pitch);
        ArgumentOutOfRangeException.ThrowIfNegativeOrZero(maxError);
        var turns = Math.Ceiling((depth / pitch) - 1e-9);
        if (!(turns <= MaxTurns)) return null;
        var (sense, rounds) = (clockwise ? -1.0 : 1.0, Math.Max(1, (int)turns));
        List<Segment> source = [.. Enumerable.Repeat(Segment.FromArc(new ArcSegment(centre, radius, Angle.Zero, Angle.FullTurn * sense)), rounds + 1)];
        for (double steps = MinSteps; steps * (rounds + 1) < MaxSteps; steps = Math.Ceiling(steps * 1.1))
        {
            if (With((int)steps, rounds) is { } one && one.VerifiedBound <= maxError) return one;
        }

        return null;

        Trajectory? With(int steps, int rounds)
        {
            var (turn, length) = (2.0 * Math.PI / steps, 2.0 * Math.PI * radius / steps);
            var sag = ((9.0 * Math.Cos(turn / 2.0)) - Math.Cos(3.0 * turn / 2.0)) / 8.0;
            var at = Enumerable.Range(-1, (steps * (rounds + 1)) + 3).ToArray();
            Point2D[] lines = [.. at.Select(i => Rounded(centre + Vector2D.FromPolar(2.0 * radius / (1.0 + sag), Angle.FromDegrees(sense * 360.0 * i / steps))))];
            double[] heights = [.. at.Select(i => Math.Round(top - (depth * Math.Min(1.0, (double)i / (steps * rounds))), SplineFit.Decimals))];
            return TrajectoryProof.Prove(lines, [.. Enumerable.Range(0, (steps * (rounds + 1)) + 1).Select(i => i * length)], source, closed: false, heights);
        }
    }

    private static Point2D Rounded(Point2D point) => new(Math.Round(point.X, SplineFit.Decimals), Math.Round(point.Y, SplineFit.Decimals));
}
