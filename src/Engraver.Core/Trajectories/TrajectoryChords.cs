using Engraver.Core.Geometry;

namespace Engraver.Core.Trajectories;

/// <summary>A trajectory whose points have heights (a helix) as straight lines in space: for machines without splines and rising arcs.</summary>
public static class TrajectoryChords
{
    /// <summary>Maximum number of chords of one step.</summary>
    private const double MaxChords = 100_000.0;

    /// <summary>The curve that a controller runs, sampled at points so close together that every chord is within the error of it (du^2/8 max|D''|, as in the
    /// proof of its bound).</summary>
    /// <param name="trajectory">A trajectory with heights.</param>
    /// <param name="maxError">Largest error, millimetres, above 0.</param>
    public static IReadOnlyList<RaisedSegment> OfCurve(Trajectory trajectory, double maxError)
    {
        var heights = HeightsOf(trajectory, maxError);
        var spline = new CatmullRomSpline([.. trajectory.Lines]);
        var places = new List<(Point2D Place, double Z)> { (spline[0].A, heights[1]) };
        for (var i = 0; i < spline.Count; i++)
        {
            var (cubic, z) = (spline[i], SpaceBound.HeightControls(heights, i));
            var chords = Number(SpaceBound.LargestBend(cubic, z), maxError);
            for (var k = 1; k <= chords; k++) places.Add(k == chords ? (cubic.D, z[3]) : (cubic.At(k / chords), SpaceBound.HeightAt(z, k / chords)));
        }

        return Joined(places);
    }

    /// <summary>The source of the trajectory, rising evenly from knot to knot.</summary>
    /// <param name="trajectory">A trajectory with heights.</param>
    /// <param name="maxError">Largest error, millimetres, above 0.</param>
    public static IReadOnlyList<RaisedSegment> OfSource(Trajectory trajectory, double maxError)
    {
        var heights = HeightsOf(trajectory, maxError);
        var chain = SmoothChain.From(trajectory.Source, trajectory.Closed);
        var curvature = chain.Pieces.Max(piece => Math.Abs(piece.At(0.5).Curvature));
        var places = new List<(Point2D Place, double Z)> { (chain.At(trajectory.Knots[0]).Point, heights[1]) };
        for (var i = 0; i + 1 < trajectory.Knots.Count; i++)
        {
            var (from, step) = (trajectory.Knots[i], trajectory.Knots[i + 1] - trajectory.Knots[i]);
            var chords = Number(step * step * curvature, maxError);
            for (var k = 1; k <= chords; k++) places.Add((chain.At(from + (k / chords * step)).Point, heights[i + 1] + (k / chords * (heights[i + 2] - heights[i + 1]))));
        }

        return Joined(places);
    }

    private static IReadOnlyList<double> HeightsOf(Trajectory trajectory, double maxError)
    {
        ArgumentNullException.ThrowIfNull(trajectory);
        ArgumentOutOfRangeException.ThrowIfNegativeOrZero(maxError);
        return trajectory.Heights ?? throw new ArgumentException("The trajectory has no heights.", nameof(trajectory));
    }

    private static double Number(double bend, double maxError) => Math.Clamp(Math.Ceiling(Math.Sqrt(bend / (8.0 * maxError))), 1.0, MaxChords);

    private static List<RaisedSegment> Joined(List<(Point2D Place, double Z)> places)
    {
        var lines = new List<RaisedSegment>(places.Count);
        for (var i = 1; i < places.Count; i++) lines.Add(new RaisedSegment(Segment.FromLine(places[i - 1].Place, places[i].Place), places[i - 1].Z, places[i].Z));
        return lines;
    }
}
