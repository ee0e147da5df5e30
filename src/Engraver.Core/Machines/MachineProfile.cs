using Engraver.Core.Geometry;
using Engraver.Core.Machines.Moves;

namespace Engraver.Core.Machines;

/// <summary>The machine as its owner describes it. The defaults are those of the default machine profile.</summary>
public sealed record MachineProfile
{
    public static MachineProfile Default { get; } = new();

    /// <summary>The controller family that the profile names; null for none: the program's default family drives the machine.</summary>
    public IControllerFamily? Controller { get; init; }

    /// <summary>The axes of the controller that move the drawing's X and Y, and their counts per millimetre.</summary>
    public MachineAxes Axes { get; init; } = MachineAxes.Default;

    /// <summary>Cutting speed along the path, mm/min.</summary>
    public double FeedMmPerMinute { get; init; } = 1200.0;

    /// <summary>Speed of each axis between strokes, mm/min.</summary>
    public double RapidMmPerMinute { get; init; } = 3000.0;

    /// <summary>Acceleration and deceleration of the path and of each axis, counts/s2.</summary>
    public int AccelerationCounts { get; init; } = 256000;

    /// <summary>Largest acceleration of the X axis while it cuts, counts/s2; null: <see cref="AccelerationCounts"/> alone bounds it.</summary>
    public int? AccelerationX { get; init; }

    /// <summary>The same of the Y axis.</summary>
    public int? AccelerationY { get; init; }

    /// <summary>Acceleration and deceleration of an axis of the job in a rapid, counts/s2.</summary>
    public int RapidAcceleration(MachineAxis axis) => Math.Min(AccelerationCounts, axis.Letter == Axes.X.Letter ? AccelerationX ?? int.MaxValue : axis.Letter == Axes.Y.Letter ? AccelerationY ?? int.MaxValue : int.MaxValue);

    /// <summary>Digital output that switches the tool (1 to 8).</summary>
    public int ToolOutput { get; init; } = 1;

    /// <summary>The tool works while the output is off, as with a relay with a normally closed contact.</summary>
    public bool ToolActiveLow { get; init; }

    /// <summary>Time to wait after the tool is switched on, and after it is switched off unless <see cref="ToolOffSettleSeconds"/> states another time;
    /// seconds.</summary>
    public double ToolSettleSeconds { get; init; } = 0.1;

    /// <summary>Time to wait after the tool is switched off, seconds; null: as after it is switched on.</summary>
    public double? ToolOffSettleSeconds { get; init; }

    /// <summary>The Z axis plunges and retracts the tool; null where an output switches it (the tool drive of the profile).</summary>
    public HeightDrive? Height { get; init; }

    /// <summary>The motor that turns the tool; null where the machine has none that this program switches.</summary>
    public Spindle? Spindle { get; init; }

    /// <summary>Sets the power of a beam; null where it is set by hand.</summary>
    public AnalogOutput? Power { get; init; }

    /// <summary>Outputs that the operations of the job switch besides tool and spindle, bit 0 is output 1: a stop switches them off.</summary>
    public int OperationOutputs { get; init; }

    /// <summary>Maximum position error of a healthy axis, mm; null: <see cref="FollowingErrorAt"/> computes it for a speed. A larger one means that the axis is
    /// jammed or its motor cannot follow.</summary>
    public double? FollowingErrorMm { get; init; }

    /// <summary>Maximum position error of a healthy axis at a speed, mm: where the profile does not state it, 0.5 mm of friction plus the distance of 0.07 s,
    /// by which a slow servo lags behind its command.</summary>
    /// <param name="mmPerSecond">Speed of the axis or of the path.</param>
    public double FollowingErrorAt(double mmPerSecond) => FollowingErrorMm ?? FrictionErrorMm + (SlowestLagSeconds * mmPerSecond);

    /// <summary>The highest speed of an axis in a job, mm/s: a rapid, or the feed at its highest override.</summary>
    public double FastestMmPerSecond => Math.Max(RapidMmPerMinute, FeedMmPerMinute * JobControl.FeedRange.Max) / 60.0;

    private const double FrictionErrorMm = 0.5;

    private const double SlowestLagSeconds = 0.07;

    /// <summary>Steps in which the controller holds the angles of CR, degrees (galil-dmc.md B.3: 1/65536; older manuals 1/256).</summary>
    public double AngleQuantumDegrees { get; init; } = 1.0 / 65536.0;

    /// <summary>Machine X of the park position, mm from the controller's own zero; null where the machine has none.</summary>
    public double? ParkX { get; init; }

    /// <summary>Machine Y of the park position, mm from the controller's own zero; null where the machine has none.</summary>
    public double? ParkY { get; init; }

    /// <summary>The park position, mm from the controller's own zero; null where the machine has none.</summary>
    public Point2D? Park => ParkX is { } x && ParkY is { } y ? new Point2D(x, y) : null;

    /// <summary>Speed of a jog unless a second control requests the rapid speed, mm/min.</summary>
    public double JogMmPerMinute { get; init; } = 600.0;

    /// <summary>What the controller's inputs are wired to.</summary>
    public IoLineNames Inputs { get; init; } = IoLineNames.None;

    /// <summary>What the controller's outputs are wired to.</summary>
    public IoLineNames Outputs { get; init; } = IoLineNames.None;

    /// <summary>What machining on it costs; null where the profile does not state it.</summary>
    public JobRates? Rates { get; init; }

    /// <summary>Whether the machine has to be homed: the profile configures homing for one of its axes.</summary>
    public bool HasHoming => Axes.All.Any(axis => axis.Homing is not null);

    /// <summary>The same machine without homing: a simulated one of this profile is switched on at its machine zero.</summary>
    public MachineProfile WithoutHoming() => this with { Axes = Axes with { X = Axes.X with { Homing = null }, Y = Axes.Y with { Homing = null }, Z = Axes.Z is { } z ? z with { Homing = null } : null } };

    /// <summary>The settings on which the zero of a homed machine depends: another text is another zero, so values stored under one text are invalid under the
    /// other.</summary>
    public string HomedAs => string.Join(' ', Axes.All.Where(axis => axis.Homing is not null).Select(axis => string.Create(
        System.Globalization.CultureInfo.InvariantCulture, $"{axis.Letter}{(axis.Homing!.Plus != axis.Scale.IsMirrored ? '+' : '-')}{axis.Homing.By}@{Math.Round(axis.Scale.Exact(axis.Homing.Zero))}")));

    public CountsScale Scale => Axes.Scale;

    /// <summary>The output that is the tool, where no axis is the tool drive.</summary>
    public OutputSwitch Tool => new(ToolOutput, ToolActiveLow);

    /// <summary>The outputs that a stop switches off before it brakes. None where an axis is the tool drive: the spindle turns until the tool is out of the
    /// work.</summary>
    public IReadOnlyList<OutputSwitch> OffAtStop => Height is null ? OffAtAbort : [];

    /// <summary>The outputs that an abort switches off: everything that works on the material.</summary>
    public IReadOnlyList<OutputSwitch> OffAtAbort => [.. ToolAndSpindle, .. OutputSwitch.Of(OperationOutputs)];

    private IEnumerable<OutputSwitch> ToolAndSpindle =>
        [.. Height is null ? [Tool] : (OutputSwitch[])[], .. Spindle is { } spindle ? [new OutputSwitch(spindle.Output, spindle.IsActiveLow)] : (OutputSwitch[])[]];

    /// <summary>Whether the device on an output is on at this level: for tool and spindle their wiring decides, for any other output the level
    /// itself.</summary>
    /// <param name="output">From 1.</param>
    public bool IsOnAt(int output, bool level) => ToolAndSpindle.Where(carried => carried.Output == output).Select(carried => level != carried.IsActiveLow).FirstOrDefault(level);

    /// <summary>Whether this level of an output is for jobs only: it switches on a device that works on the material, and only a job's watchdog would switch it
    /// off again.</summary>
    public bool IsForJobsOnly(int output, bool level) => Height is null && ToolAndSpindle.Any(carried => carried.Output == output && level != carried.IsActiveLow);

    /// <summary>Whether an output switches the tool or the spindle.</summary>
    public bool IsToolOrSpindle(int output) => ToolAndSpindle.Any(carried => carried.Output == output);

    /// <summary>Letter of the axis whose analog output sets the speed of the spindle or the power of the beam; null for none.</summary>
    public char? AnalogAxis => Spindle?.SpeedAxis ?? Power?.Axis;

    /// <summary>Time to wait after the tool is switched off, seconds.</summary>
    public double OffSettleSeconds => ToolOffSettleSeconds ?? ToolSettleSeconds;

    /// <summary>The clearance height in counts above the drawing's height 0; 0 without a tool axis.</summary>
    public int ClearanceCounts => Scale.ToHeight(Height?.ClearanceHeight ?? 0.0);

    /// <summary>The retract height in counts above the drawing's height 0; 0 without a tool axis.</summary>
    public int RetractCounts => Scale.ToHeight(Height?.RetractHeight ?? 0.0);

    /// <summary>+1 where the Z axis counts upwards, -1 where downwards; 0 on a machine without one.</summary>
    public int UpSign => Scale.Z.Sign;

    /// <summary>Whether one height is below another, counts; false on a machine without a Z axis.</summary>
    public bool IsLower(int z, int other) => z * (long)UpSign < other * (long)UpSign;
}
