using Engraver.Core.Geometry;

namespace Engraver.Core.Trajectories;

/// <summary>The curve that a controller runs through the points of a trajectory, for display and for machines without splines.</summary>
public static class TrajectoryCurve
{
    /// <summary>The whole curve, exactly: a cubic for each step.</summary>
    public static RationalCurve Of(Trajectory trajectory)
    {
        ArgumentNullException.ThrowIfNull(trajectory);
        var spline = new CatmullRomSpline([.. trajectory.Lines]);
        return new RationalCurve(SegmentKind.Spline, [.. Enumerable.Range(0, spline.Count).Select(i => SpanOf(spline[i]))]);
    }

    /// <summary>The curve in exact parts, each with its distance from the source, for colours.</summary>
    /// <param name="parts">Number of parts of each step, at least 1.</param>
    public static IReadOnlyList<TrajectoryPart> Parts(Trajectory trajectory, int parts)
    {
        ArgumentNullException.ThrowIfNull(trajectory);
        ArgumentOutOfRangeException.ThrowIfLessThan(parts, 1);
        var (spline, chain, made) = (new CatmullRomSpline([.. trajectory.Lines]), SmoothChain.From(trajectory.Source, trajectory.Closed), new List<TrajectoryPart>());
        for (var i = 0; i < spline.Count; i++)
        {
            var (from, step, rest) = (trajectory.Knots[i], trajectory.Knots[i + 1] - trajectory.Knots[i], spline[i]);
            for (var k = 0; k < parts; k++)
            {
                var (part, left) = k + 1 < parts ? rest.Split(1.0 / (parts - k)) : (rest, rest);
                var middle = part.At(0.5);
                made.Add(new TrajectoryPart(Segment.FromCurve(new RationalCurve(SegmentKind.Spline, [SpanOf(part)])), Math.Abs(chain.Beside(middle, from + ((k + 0.5) / parts * step)).Distance)));
                rest = left;
            }
        }

        return made;
    }

    /// <summary>The places where the source turns sharply: between two trajectories of one contour, and within a trajectory that runs through
    /// corners.</summary>
    public static IReadOnlyList<Point2D> CornersOf(Trajectory trajectory)
    {
        ArgumentNullException.ThrowIfNull(trajectory);
        var chain = SmoothChain.From(trajectory.Source, trajectory.Closed);
        return [.. chain.Joints.Where(joint => joint.IsCorner).Select(joint => chain.At(joint.At).Point)];
    }

    private static BezierSpan SpanOf(in Cubic cubic) => new([cubic.A.X, cubic.A.Y, 0.0, 1.0, cubic.B.X, cubic.B.Y, 0.0, 1.0, cubic.C.X, cubic.C.Y, 0.0, 1.0, cubic.D.X, cubic.D.Y, 0.0, 1.0]);
}
