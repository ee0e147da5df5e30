using Engraver.Core.Machines;

namespace Engraver.Core.Trajectories.Formats;

/// <summary>Limits of a machine: the speed of a trajectory, and its travel.</summary>
/// <param name="Velocity">Velocity along the path, mm/s.</param>
/// <param name="Acceleration">Acceleration along the path and of each axis, mm/s2.</param>
public sealed record TrajectoryMotion(double Velocity, double Acceleration)
{
    /// <summary>Travel of the axes of the drawing, millimetres; null when unknown.</summary>
    public double? TravelX { get; init; }

    public double? TravelY { get; init; }

    /// <summary>Feed and acceleration of a machine, along the path.</summary>
    public static TrajectoryMotion Of(MachineProfile machine)
    {
        ArgumentNullException.ThrowIfNull(machine);
        return new TrajectoryMotion(machine.FeedMmPerMinute / 60.0, machine.Scale.Finer.LengthOf(machine.AccelerationCounts))
        {
            TravelX = ReachOf(machine.Axes.X),
            TravelY = ReachOf(machine.Axes.Y),
        };
    }

    private static double? ReachOf(MachineAxis axis) => axis.Travel is { } travel ? travel.Max - travel.Min : null;
}
