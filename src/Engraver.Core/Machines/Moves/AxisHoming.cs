namespace Engraver.Core.Machines.Moves;

/// <summary>How one axis is homed: what is searched, where, how fast, and what the machine counts there.</summary>
public sealed record AxisHoming
{
    /// <summary>What the place is known by.</summary>
    public HomingMark By { get; init; } = HomingMark.Switch;

    /// <summary>What the home input reads while the axis is on the home switch, 0 or 1: it depends on the switch and on the polarity that is set in the controller.</summary>
    public int OnSwitch { get; init; }

    /// <summary>Where it is searched: true towards larger machine millimetres.</summary>
    public bool Plus { get; init; }

    /// <summary>Speed of the search, mm/min.</summary>
    public double FastMmPerMinute { get; init; } = 600.0;

    /// <summary>Speed at which the edge or the index is taken, mm/min. The controller sees it about once in a millisecond, so this speed is the error.</summary>
    public double SlowMmPerMinute { get; init; } = 60.0;

    /// <summary>How far the axis moves away from the mark in the end, mm; at least 0.</summary>
    public double BackOff { get; init; } = 2.0;

    /// <summary>The machine position of the mark, mm.</summary>
    public double Zero { get; init; }

    /// <summary>Controller seconds after which the homing of this axis is given up.</summary>
    public double Seconds { get; init; } = 120.0;

    /// <summary>Axes are homed one after the other, the smallest number first.</summary>
    public int Order { get; init; }

    /// <summary>What is searched first is the home switch or the limit switch, and not the index alone.</summary>
    public bool HasSwitch => By != HomingMark.Index;

    /// <summary>The mark is an index pulse.</summary>
    public bool HasIndex => By is HomingMark.Index or HomingMark.SwitchIndex or HomingMark.LimitIndex;

    /// <summary>The switch is the limit switch.</summary>
    public bool ByLimit => By is HomingMark.Limit or HomingMark.LimitIndex;
}

/// <summary>What the home position of an axis is known by.</summary>
public enum HomingMark
{
    /// <summary>The edge of the home switch.</summary>
    Switch,

    /// <summary>The edge of the limit switch in the direction of the search.</summary>
    Limit,

    /// <summary>The index pulse of the encoder, searched from where the axis stands.</summary>
    Index,

    /// <summary>The first index pulse on the way back from the home switch.</summary>
    SwitchIndex,

    /// <summary>The first index pulse on the way back from the limit switch.</summary>
    LimitIndex,
}
