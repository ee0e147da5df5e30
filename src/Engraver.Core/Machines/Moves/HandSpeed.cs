namespace Engraver.Core.Machines.Moves;

/// <summary>How fast a machine may be moved by hand: the one place that says so, for jogs and steps of pad, command and console.</summary>
public static class HandSpeed
{
    /// <summary>The rapid speed. A machine that has to be homed and is not has no soft limits, and nobody knows how far its switches are: it goes no faster than a jog without the second control, and than its axes search their switches.</summary>
    /// <param name="isHomed">Null for a machine without homing.</param>
    /// <returns>Of each axis, mm/min.</returns>
    public static double Fastest(MachineProfile profile, bool? isHomed)
    {
        ArgumentNullException.ThrowIfNull(profile);
        if (isHomed != false) return profile.RapidMmPerMinute;
        var searches = profile.Axes.All.Where(axis => axis.Homing is not null).Select(axis => axis.Homing!.FastMmPerMinute);
        return searches.Append(profile.JogMmPerMinute).Append(profile.RapidMmPerMinute).Min();
    }
}
