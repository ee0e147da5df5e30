using Engraver.Core.Geometry;

namespace Engraver.Core.Machines;

/// <summary>The machine as its owner describes it. The defaults are the default machine profile of the runner's contract.</summary>
public sealed record MachineProfile
{
    public static MachineProfile Default { get; } = new();

    /// <summary>The axes of the controller that move the drawing's X and Y, and their counts per millimetre.</summary>
    public MachineAxes Axes { get; init; } = MachineAxes.Default;

    /// <summary>Cutting speed along the path, mm/min.</summary>
    public double FeedMmPerMinute { get; init; } = 1200.0;

    /// <summary>Speed of each axis between strokes, mm/min.</summary>
    public double RapidMmPerMinute { get; init; } = 3000.0;

    /// <summary>Of the path and of each axis, speeding up and slowing down, counts/s2.</summary>
    public int AccelerationCounts { get; init; } = 256000;

    /// <summary>A path turns without a stop up to this angle between two moves, degrees.</summary>
    public double SharpCornerDegrees { get; init; } = 10.0;

    /// <summary>Digital output that carries the tool (1 to 8).</summary>
    public int ToolOutput { get; init; } = 1;

    /// <summary>Time to wait after the tool is switched on or off, seconds.</summary>
    public double ToolSettleSeconds { get; init; } = 0.1;

    /// <summary>Steps in which the controller holds the angles of CR, degrees (galil-dmc.md B.3: 1/65536; older manuals 1/256).</summary>
    public double AngleQuantumDegrees { get; init; } = 1.0 / 65536.0;

    /// <summary>Machine X at which the machine is parked, mm by the controller's own zero; null where the machine has no such place.</summary>
    public double? ParkX { get; init; }

    /// <summary>Machine Y at which the machine is parked, mm by the controller's own zero; null where the machine has no such place.</summary>
    public double? ParkY { get; init; }

    /// <summary>The place where the machine is parked, mm by the controller's own zero; null where it has none.</summary>
    public Point2D? Park => ParkX is { } x && ParkY is { } y ? new Point2D(x, y) : null;

    public CountsScale Scale => Axes.Scale;
}
