using Engraver.Core.Machines;

namespace Engraver.Galil.Language;

/// <summary>Converts settings of a machine profile to values of controller commands.</summary>
public static class DmcProfile
{
    /// <summary>VS for the feed, even counts/s. 1200 mm/min at 1000 counts/mm is 20000. With unequal axes the scale of the coarser axis is used: a cut is never
    /// faster than the feed.</summary>
    public static int VectorSpeed(this MachineProfile profile)
    {
        ArgumentNullException.ThrowIfNull(profile);
        return EvenCountsPerSecond(profile.FeedMmPerMinute, profile.Scale.Coarser);
    }

    /// <summary>SP of one axis, even counts/s.</summary>
    public static int RapidSpeed(this MachineProfile profile, MachineAxis axis)
    {
        ArgumentNullException.ThrowIfNull(profile);
        return EvenCountsPerSecond(profile.RapidMmPerMinute, axis.Scale);
    }

    /// <summary>SP or JG of one axis for a speed given separately, even counts/s, limited to the controller's maximum.</summary>
    /// <param name="mmPerMinute">At least 0.</param>
    public static int AxisSpeed(this MachineAxis axis, double mmPerMinute) => Math.Min(DmcLimits.FastestSpeed, EvenCountsPerSecond(mmPerMinute, axis.Scale));

    /// <summary>SP of the Z axis below the retract height, even counts/s.</summary>
    public static int PlungeSpeed(this MachineProfile profile)
    {
        ArgumentNullException.ThrowIfNull(profile);
        return profile.PlungeSpeed(profile.Height?.PlungeMmPerMinute ?? 0.0);
    }

    /// <param name="mmPerMinute">Speed straight down.</param>
    internal static int PlungeSpeed(this MachineProfile profile, double mmPerMinute) => EvenCountsPerSecond(mmPerMinute, profile.Scale.Z);

    /// <summary>SP of the Z axis below the retract height at one stroke, even counts/s.</summary>
    public static int PlungeSpeed(this MachineProfile profile, StrokeTerms? terms) => terms?.PlungeSpeed ?? profile.PlungeSpeed();

    /// <summary>The settle time as WT needs it: an even number of milliseconds, 0 for no wait (galil-dmc.md F.5).</summary>
    /// <param name="on">True for the time after the tool is switched on, false for the time after it is switched off.</param>
    public static int SettleMilliseconds(this MachineProfile profile, bool on = true)
    {
        ArgumentNullException.ThrowIfNull(profile);
        return EvenMilliseconds(on ? profile.ToolSettleSeconds : profile.OffSettleSeconds);
    }

    /// <summary>A time as WT needs it: an even number of milliseconds, rounded up.</summary>
    public static int EvenMilliseconds(double seconds) => 2 * (int)Math.Ceiling(Math.Round(seconds * 1000.0, 6) / 2.0);

    private static int EvenCountsPerSecond(double mmPerMinute, AxisScale scale) =>
        Math.Max(DmcLimits.SlowestSpeed, 2 * (int)Math.Round(scale.CountsOf(mmPerMinute / 60.0) / 2.0, MidpointRounding.AwayFromZero));
}
