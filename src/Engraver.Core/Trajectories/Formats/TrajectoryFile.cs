using System.Globalization;
using Engraver.Core.Geometry;
using Engraver.Core.Machines;

namespace Engraver.Core.Trajectories.Formats;

/// <summary>One trajectory as the text of a file, with what is known of what a controller makes of it. Lengths in millimetres.</summary>
/// <param name="Text">With the line ends of its format.</param>
/// <param name="Start">Where the machine must stand when the file is started, drawing coordinates; the XPS formats count from there.</param>
/// <param name="Points">Places visited, both ends included.</param>
/// <param name="SampledError">Largest distance of what the text says from the source at dense samples.</param>
/// <param name="VerifiedBound">Proven: no point of what is run is farther from the source, and none of the source from it.</param>
/// <param name="SpacingRatio">Largest ratio of neighbouring steps; 1 where steps may differ freely.</param>
public sealed record TrajectoryFile(
    string Text, Point2D Start, double Z, int Points, double SampledError, double VerifiedBound, double SpacingRatio, double Length, bool Closed, IReadOnlyList<Segment> Source)
{
    /// <summary>What the controller does not take, each in a few words; empty when it takes the file.</summary>
    public IReadOnlyList<string> BrokenLimits { get; init; } = [];

    /// <summary>The largest speed along the path, mm/s, at which no axis needs more acceleration than it has; null where the file itself says how fast, or nothing is known.</summary>
    public double? MaxSpeed { get; init; }

    /// <summary>A number of a file: invariant, without exponent, as exact as the points are.</summary>
    internal static string Number(double value) => (Math.Round(value, SplineFit.Decimals) + 0.0).ToString("0.#########", CultureInfo.InvariantCulture);

    /// <summary>The same with at least six decimals, as the manuals write them.</summary>
    internal static string LongNumber(double value) => (Math.Round(value, SplineFit.Decimals) + 0.0).ToString("0.000000###", CultureInfo.InvariantCulture);
}

/// <summary>For which controller a trajectory is written.</summary>
public enum TrajectoryFormat
{
    /// <summary>The text of SACETraj: absolute places (sace-xps-agie.md 1.3).</summary>
    Sace,

    /// <summary>The spline of an XPS controller's XYZ group.</summary>
    XpsSpline,

    /// <summary>Lines and arcs of an XPS controller's XY group.</summary>
    XpsLineArc,

    /// <summary>Positions, velocities and times of an XPS controller's MultipleAxes group.</summary>
    XpsPvt,
}

/// <summary>What a machine may do: how fast a trajectory is run, and how far.</summary>
/// <param name="Velocity">Along the path, mm/s.</param>
/// <param name="Acceleration">Along the path and of each axis, mm/s2.</param>
public sealed record TrajectoryMotion(double Velocity, double Acceleration)
{
    /// <summary>How far the axes of the drawing reach, millimetres; null where that is not known.</summary>
    public double? TravelX { get; init; }

    public double? TravelY { get; init; }

    /// <summary>Feed and acceleration of a machine, along the path.</summary>
    public static TrajectoryMotion Of(MachineProfile machine)
    {
        ArgumentNullException.ThrowIfNull(machine);
        return new TrajectoryMotion(machine.FeedMmPerMinute / 60.0, machine.AccelerationCounts / Math.Max(Math.Abs(machine.Scale.X), Math.Abs(machine.Scale.Y)))
        {
            TravelX = ReachOf(machine.Axes.X),
            TravelY = ReachOf(machine.Axes.Y),
        };
    }

    private static double? ReachOf(MachineAxis axis) => axis.Travel is { } travel ? travel.Most - travel.Least : null;
}
