using Engraver.Core.Geometry;

namespace Engraver.Core.Trajectories.Formats;

/// <summary>Requirements of a file for a machine: the travel of its axes, and the speed above which an axis needs more than its acceleration.</summary>
internal static class MotionLimits
{
    /// <summary>Number of samples of a cubic for its curvature.</summary>
    private const int Samples = 32;

    /// <summary>Names an axis whose travel is shorter than the cubics need; the file does not state the position on it.</summary>
    public static IEnumerable<string> BrokenTravel(IEnumerable<Segment> run, TrajectoryMotion motion)
    {
        var box = run.Aggregate(Bounds2D.Empty, (box, segment) => box.Union(segment.Bounds));
        if (box.IsEmpty) yield break;
        if (box.Width > motion.TravelX) yield return Wording.Get("Xps.TravelExceeded", "X", NumberText.Rounded(box.Width, 4), NumberText.Rounded(motion.TravelX.Value, 4));
        if (box.Height > motion.TravelY) yield return Wording.Get("Xps.TravelExceeded", "Y", NumberText.Rounded(box.Height, 4), NumberText.Rounded(motion.TravelY.Value, 4));
    }

    /// <summary>The largest speed along the path at which no axis exceeds its acceleration: at a constant speed v the acceleration is v^2 times the curvature,
    /// across the path.</summary>
    /// <returns>Speed, mm/s; infinite for a straight line.</returns>
    public static double SpeedOf(CatmullRomSpline spline, double acceleration)
    {
        var most = 0.0;
        for (var i = 0; i < spline.Count; i++)
        {
            var cubic = spline[i];
            for (var k = 0; k <= Samples; k++) most = Math.Max(most, AxisCurvature(cubic, (double)k / Samples));
        }

        return Speed(most, acceleration);
    }

    /// <summary>The same for lines and arcs.</summary>
    public static double SpeedOf(IEnumerable<Segment> run, double acceleration) =>
        Speed(run.Where(segment => segment.Kind != SegmentKind.Line).Select(segment => 1.0 / segment.Arc.Radius).DefaultIfEmpty().Max(), acceleration);

    private static double Speed(double curvature, double acceleration) => curvature > 0.0 ? Math.Sqrt(acceleration / curvature) : double.PositiveInfinity;

    /// <summary>The larger axis component of the curvature vector.</summary>
    private static double AxisCurvature(in Cubic cubic, double u)
    {
        var slope = cubic.SlopeAt(u);
        var (v, speed) = (1.0 - u, slope.Length);
        if (!(speed > 0.0)) return 0.0;
        var bend = (((cubic.C - cubic.B) - (cubic.B - cubic.A)) * (6.0 * v)) + (((cubic.D - cubic.C) - (cubic.C - cubic.B)) * (6.0 * u));
        var curvature = slope.Cross(bend) / (speed * speed * speed);
        return Math.Abs(curvature) * Math.Max(Math.Abs(slope.X), Math.Abs(slope.Y)) / speed;
    }
}
