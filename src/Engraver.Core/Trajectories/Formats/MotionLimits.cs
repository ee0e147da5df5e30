using System.Globalization;
using Engraver.Core.Geometry;

namespace Engraver.Core.Trajectories.Formats;

/// <summary>What a machine would have to do to run a file: how far its axes go, and how fast it may be run before one of them needs more acceleration than it has.</summary>
internal static class MotionLimits
{
    /// <summary>Samples of a cubic for its curvature.</summary>
    private const int Samples = 32;

    /// <summary>Names an axis whose travel is shorter than what the cubics need; the file says nothing of where on it.</summary>
    public static IEnumerable<string> BrokenTravel(IEnumerable<Segment> run, TrajectoryMotion motion)
    {
        var box = run.Aggregate(Bounds2D.Empty, (box, segment) => box.Union(segment.Bounds));
        if (box.IsEmpty) yield break;
        if (box.Width > motion.TravelX) yield return Wording.Get("Xps.TravelExceeded", "X", Fact(box.Width), Fact(motion.TravelX.Value));
        if (box.Height > motion.TravelY) yield return Wording.Get("Xps.TravelExceeded", "Y", Fact(box.Height), Fact(motion.TravelY.Value));
    }

    /// <summary>The largest speed along the path at which no axis needs more acceleration than it has: at an even speed v the acceleration is v^2 times the curvature, across the path.</summary>
    /// <returns>mm/s; infinite for a straight line.</returns>
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

    /// <summary>The same of lines and arcs.</summary>
    public static double SpeedOf(IEnumerable<Segment> run, double acceleration) =>
        Speed(run.Where(segment => segment.Kind != SegmentKind.Line).Select(segment => 1.0 / segment.Arc.Radius).DefaultIfEmpty().Max(), acceleration);

    private static double Speed(double curvature, double acceleration) => curvature > 0.0 ? Math.Sqrt(acceleration / curvature) : double.PositiveInfinity;

    /// <summary>The larger part along an axis of the curvature vector.</summary>
    private static double AxisCurvature(in Cubic cubic, double u)
    {
        var slope = cubic.SlopeAt(u);
        var (v, speed) = (1.0 - u, slope.Length);
        if (!(speed > 0.0)) return 0.0;
        var bend = (((cubic.C - cubic.B) - (cubic.B - cubic.A)) * (6.0 * v)) + (((cubic.D - cubic.C) - (cubic.C - cubic.B)) * (6.0 * u));
        var curvature = slope.Cross(bend) / (speed * speed * speed);
        return Math.Abs(curvature) * Math.Max(Math.Abs(slope.X), Math.Abs(slope.Y)) / speed;
    }

    private static string Fact(double value) => value.ToString("0.####", CultureInfo.InvariantCulture);
}
