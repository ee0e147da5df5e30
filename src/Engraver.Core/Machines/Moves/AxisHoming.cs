namespace Engraver.Core.Machines.Moves;

/// <summary>How one axis is homed: the mark to search, the direction, the speeds, and the machine position of the mark.</summary>
public sealed record AxisHoming
{
    /// <summary>The mark that defines the home position.</summary>
    public HomingMark By { get; init; } = HomingMark.Switch;

    /// <summary>The level of the home input while the axis is on the home switch, 0 or 1: it depends on the switch and on the polarity that is set in the
    /// controller.</summary>
    public int OnSwitch { get; init; }

    /// <summary>Direction of the search: true towards larger machine millimetres.</summary>
    public bool Plus { get; init; }

    /// <summary>Speed of the search, mm/min.</summary>
    public double FastMmPerMinute { get; init; } = 600.0;

    /// <summary>Speed at which the edge or the index is detected, mm/min. The controller reads it about once in a millisecond, so this speed determines the
    /// error.</summary>
    public double SlowMmPerMinute { get; init; } = 60.0;

    /// <summary>Distance that the axis finally moves away from the mark, mm; at least 0.</summary>
    public double BackOff { get; init; } = 2.0;

    /// <summary>The machine position of the mark, mm.</summary>
    public double Zero { get; init; }

    /// <summary>Timeout of the homing of this axis, controller seconds.</summary>
    public double Seconds { get; init; } = 120.0;

    /// <summary>Axes are homed one after the other, the smallest number first.</summary>
    public int Order { get; init; }

    /// <summary>The home switch or the limit switch is searched first, not the index alone.</summary>
    public bool HasSwitch => By != HomingMark.Index;

    /// <summary>The mark is an index pulse.</summary>
    public bool HasIndex => By is HomingMark.Index or HomingMark.SwitchIndex or HomingMark.LimitIndex;

    /// <summary>The switch is the limit switch.</summary>
    public bool ByLimit => By is HomingMark.Limit or HomingMark.LimitIndex;
}
