using Engraver.Core.Geometry;

namespace Engraver.Core.Machines;

/// <summary>The machine as its owner describes it. The defaults are the default machine profile of the runner's contract.</summary>
public sealed record MachineProfile
{
    public static MachineProfile Default { get; } = new();

    /// <summary>Counts (quadrature counts or steps) per millimetre of axis A, the drawing's X. Negative mirrors the axis.</summary>
    public double CountsPerMillimetreX { get; init; } = 1000.0;

    /// <summary>Counts per millimetre of axis B, the drawing's Y.</summary>
    public double CountsPerMillimetreY { get; init; } = 1000.0;

    /// <summary>Cutting speed along the path, mm/min.</summary>
    public double FeedMmPerMinute { get; init; } = 1200.0;

    /// <summary>Speed of each axis between strokes, mm/min.</summary>
    public double RapidMmPerMinute { get; init; } = 3000.0;

    /// <summary>VA = VD = AC = DC, counts/s2.</summary>
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

    /// <summary>The same of Y.</summary>
    public double? ParkY { get; init; }

    /// <summary>The place where the machine is parked, mm by the controller's own zero; null where it has none.</summary>
    public Point2D? Park => ParkX is { } x && ParkY is { } y ? new Point2D(x, y) : null;

    public CountsScale Scale => new(CountsPerMillimetreX, CountsPerMillimetreY);

    /// <summary>The settle time as WT takes it: an even number of milliseconds, 0 for no wait (galil-dmc.md F.5).</summary>
    public int ToolSettleMilliseconds => 2 * (int)Math.Ceiling(Math.Round(ToolSettleSeconds * 1000.0, 6) / 2.0);

    /// <summary>Vector speed for the feed, even counts/s. 1200 mm/min at 1000 counts/mm is 20000. With unequal axes the finer one only sets the pace of its own direction,
    /// so the coarser one decides: no direction is cut faster than the feed.</summary>
    public int VectorSpeed => EvenCountsPerSecond(FeedMmPerMinute, Scale.Smallest);

    public int RapidSpeedX => EvenCountsPerSecond(RapidMmPerMinute, Math.Abs(CountsPerMillimetreX));

    public int RapidSpeedY => EvenCountsPerSecond(RapidMmPerMinute, Math.Abs(CountsPerMillimetreY));

    private static int EvenCountsPerSecond(double mmPerMinute, double countsPerMillimetre) =>
        Math.Max(2, 2 * (int)Math.Round(mmPerMinute / 60.0 * countsPerMillimetre / 2.0, MidpointRounding.AwayFromZero));
}
