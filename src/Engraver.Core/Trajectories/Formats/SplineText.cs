using System.Text;
using Engraver.Core.Geometry;

namespace Engraver.Core.Trajectories.Formats;

/// <summary>Splines as lines of points, for the SACE bench and for the XYZ group of an XPS controller.</summary>
public static class SplineText
{
    /// <summary>One point per line, <c>x, y, z</c>, Windows line ends, no header, positions of the drawing; the first and the last line are the phantom points
    /// (sace-xps-agie.md 1.3).</summary>
    public static TrajectoryFile Sace(Trajectory trajectory)
    {
        ArgumentNullException.ThrowIfNull(trajectory);
        return FileOf(trajectory, Lines(trajectory, default, 0.0, ", ", "\r\n"));
    }

    /// <summary>One point per line, <c>x,y,z</c>, moved so that the second line is exactly 0,0,0: a controller that adds it and one that does not then run the
    /// same path (sace-xps-agie.md 2.3).</summary>
    /// <param name="motion">Limits of its machine.</param>
    public static TrajectoryFile Xps(Trajectory trajectory, TrajectoryMotion motion)
    {
        ArgumentNullException.ThrowIfNull(trajectory);
        ArgumentNullException.ThrowIfNull(motion);
        var file = FileOf(trajectory, Lines(trajectory, trajectory.Start - Point2D.Origin, trajectory.Z, ",", "\n"));
        var speed = MotionLimits.SpeedOf(new CatmullRomSpline([.. trajectory.Lines]), motion.Acceleration);
        return file with { BrokenLimits = [.. Repeated(trajectory), .. MotionLimits.BrokenTravel([Segment.FromCurve(TrajectoryCurve.Of(trajectory))], motion)], MaxSpeed = double.IsFinite(speed) ? speed : null };
    }

    private static string Lines(Trajectory trajectory, Vector2D origin, double bottom, string comma, string end)
    {
        var text = new StringBuilder();
        for (var i = 0; i < trajectory.Lines.Count; i++)
        {
            var point = trajectory.Lines[i];
            text.Append(TrajectoryFile.Number(point.X - origin.X)).Append(comma).Append(TrajectoryFile.Number(point.Y - origin.Y)).Append(comma).Append(TrajectoryFile.Number(trajectory.HeightAt(i) - bottom)).Append(end);
        }

        return text.ToString();
    }

    private static TrajectoryFile FileOf(Trajectory of, string text) =>
        new(text, of.Start, of.Z, of.Points, of.SampledError, of.VerifiedBound, of.SpacingRatio, of.Length, of.Closed, of.Source);

    private static IEnumerable<string> Repeated(Trajectory trajectory)
    {
        for (var i = 2; i < trajectory.Lines.Count - 1; i++)
        {
            if (trajectory.Lines[i] == trajectory.Lines[i - 1]) yield return Wording.Get("Xps.ElementWithoutLength", i);
        }
    }
}
