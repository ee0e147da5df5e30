namespace Engraver.Core.Machines.Moves;

/// <summary>The highest speed of moves by hand: the only place for it, for jogs and steps of pad, command and console.</summary>
public static class HandSpeed
{
    /// <summary>The rapid speed. A machine that has to be homed and is not homed has no soft limits, and the distance to its switches is unknown: it moves no
    /// faster than a jog without the second control, and no faster than its axes search their switches.</summary>
    /// <param name="isHomed">Null for a machine without homing.</param>
    /// <returns>Speed of each axis, mm/min.</returns>
    public static double Max(MachineProfile profile, bool? isHomed)
    {
        ArgumentNullException.ThrowIfNull(profile);
        if (isHomed != false) return profile.RapidMmPerMinute;
        var searches = profile.Axes.All.Where(axis => axis.Homing is not null).Select(axis => axis.Homing!.FastMmPerMinute);
        return searches.Append(profile.JogMmPerMinute).Append(profile.RapidMmPerMinute).Min();
    }
}
