using Engraver.Core.Geometry;
using Engraver.Core.Machines;

namespace Engraver.Core.Motion.Planning;

/// <summary>What bounds the speed along a path on one machine: the total acceleration, that of each axis, and the jump of the velocity where the direction
/// changes between two samples. Counts and seconds.</summary>
/// <param name="Total">Largest acceleration in any direction, counts/s2.</param>
/// <param name="X">Of the drawing's X axis, counts/s2; infinite where the profile does not bound it.</param>
/// <param name="Y">Of the drawing's Y axis.</param>
public readonly record struct PathLimits(double Total, double X, double Y)
{
    /// <summary>Time between two samples of the controller (TM 1000).</summary>
    public const double Sample = 0.001;

    /// <summary>Counts by which rounding can change the second difference of three positions, in one and the other direction: they define the time over which
    /// an acceleration can be measured.</summary>
    private const double RoundingCounts = 20.0;

    /// <summary>Part of the acceleration by which a jump in the direction of the ramps before and after it may exceed it.</summary>
    private const double Excess = 1.05;

    public static PathLimits Of(MachineProfile profile)
    {
        ArgumentNullException.ThrowIfNull(profile);
        return new PathLimits(profile.AccelerationCounts, profile.AccelerationX ?? double.PositiveInfinity, profile.AccelerationY ?? double.PositiveInfinity);
    }

    /// <summary>Time over which an acceleration can be measured in whole counts, seconds.</summary>
    public double MeasuredOver => Sample * Math.Ceiling(Math.Sqrt(RoundingCounts / Total) / Sample);

    /// <summary>Largest acceleration along a straight of this direction.</summary>
    /// <param name="direction">Length 1.</param>
    public double Along(PathDirection direction) => Math.Min(Total, Math.Min(X / Math.Abs(direction.X), Y / Math.Abs(direction.Y)));

    /// <summary>Largest acceleration on an arc of any direction.</summary>
    public double OnArcs => Math.Min(Total, Math.Min(X, Y));

    /// <summary>Seconds per count/s: the speed times this is the time in which the limits allow the change of velocity between two directions.</summary>
    public double TurnOf(PathDirection before, PathDirection after)
    {
        var (x, y, z) = (after.X - before.X, after.Y - before.Y, after.Z - before.Z);
        return Math.Max(double.Hypot(double.Hypot(x, y), z) / Total, Math.Max(Math.Abs(x) / X, Math.Abs(y) / Y));
    }

    /// <summary>Length between two turns up to which one measurement of the acceleration includes both, counts.</summary>
    /// <param name="speed">At the turns, counts/s.</param>
    public double CloseTurns(double speed) => (speed * MeasuredOver) + (Total * MeasuredOver * MeasuredOver / 4.0);

    /// <summary>Largest speed at which a path may turn between two segments: the change of velocity fits one sample, and where the segments are shorter than
    /// the distance of a sample, the time of a segment.</summary>
    /// <param name="turn">As <see cref="TurnOf"/>.</param>
    /// <param name="shorter">Length of the shorter of the two, counts.</param>
    public double SpeedThrough(double turn, double shorter)
    {
        if (turn <= 0.0) return double.PositiveInfinity;
        var half = Math.Min(1.0, turn * Total / 2.0); // sine of half the turn
        var part = Math.Min(1.0, MeasuredOver / Sample * (Excess - half)); // the ramps before and after a sharp turn are in its direction too
        return Math.Min(Sample * part / turn, Math.Sqrt(shorter / turn));
    }
}
