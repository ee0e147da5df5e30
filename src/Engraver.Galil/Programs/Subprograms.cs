using Engraver.Core.Machines;
using Engraver.Galil.Language;

namespace Engraver.Galil.Programs;

/// <summary>The routines in the controller for job mode calls, as lines: #LINEAR of the paper, corrected (galil-dmc.md F.0, EX1), and #CIRC, which the paper
/// does not print.</summary>
internal static class Subprograms
{
    public const string Linear = "#LINEAR";
    public const string Circular = "#CIRC";
    public const string Rapid = "#RAPID";
    public const string Slope = "#SLOPE";
    public const string Down = "#DOWN";
    public const string Up = "#UP";
    public const string CommandError = "#CMDERR";

    /// <summary>Variable: clearance height, the controller's own counts.</summary>
    public const string ClearanceHeight = "zup";

    /// <summary>Speed and acceleration of a call.</summary>
    private const string Speeds = $"VS f;VA {Acceleration};VD {Acceleration}";

    /// <summary>Variable: acceleration and deceleration of a call, counts/s2.</summary>
    private const string Acceleration = "va";

    /// <summary>Variable: speed of the tool's axis down to the work.</summary>
    private const string PlungeSpeed = "zf";

    /// <summary>Cuts a straight line to x, y relative to the machine's position, and waits for its end.</summary>
    /// <param name="last">A statement before the return ("seq=seq+1"), or empty.</param>
    public static IReadOnlyList<string> LinearLines(MachineProfile profile, string last) => Interpolation(profile, Linear, "VP x,y", last);

    /// <summary>Cuts an arc of radius r from angle th of its circle by the sweep da, and waits for its end.</summary>
    public static IReadOnlyList<string> CircularLines(MachineProfile profile, string last) => Interpolation(profile, Circular, "CR r,th,da", last);

    /// <summary>Travels to x, y in the controller's own coordinates, each axis at its rapid speed, and waits for the end.</summary>
    public static IReadOnlyList<string> RapidLines(MachineProfile profile, string last) => RapidLines(profile, TargetLine(profile, "x", "y"), last);

    /// <param name="target">The line that assigns PA.</param>
    /// <param name="last">A statement before the return, or empty.</param>
    public static IReadOnlyList<string> RapidLines(MachineProfile profile, string target, string last) =>
        new ProgramLines().Line(Rapid).Line(target).Line("BG" + profile.Axes.PlaneLetters).Line("AM" + profile.Axes.PlaneLetters).Line(last).Line("EN").Lines;

    /// <summary>PA of both axes.</summary>
    public static string TargetLine(MachineProfile profile, string x, string y) => $"PA{profile.Axes.X.Letter}={x};PA{profile.Axes.Y.Letter}={y}";

    /// <summary>Plane S, speeds and accelerations of the profile. VS is sent with every sequence. Only valid at rest.</summary>
    public static IReadOnlyList<string> SetUpLines(MachineProfile profile)
    {
        var acceleration = profile.AccelerationCounts;
        return new ProgramLines()
            .Line("CAS", DmcFormat.Text($"VA {acceleration}"), DmcFormat.Text($"VD {acceleration}"))
            .Line([.. AccelerationCommands(profile)])
            .Line([.. profile.Axes.All.Select(axis => DmcFormat.Text($"SP{axis.Letter}={profile.RapidSpeed(axis)}"))])
            .Lines;
    }

    /// <summary>AC and DC of every axis of the job.</summary>
    public static IReadOnlyList<string> AccelerationCommands(MachineProfile profile) =>
        [.. profile.Axes.All.Select(axis => DmcFormat.Text($"AC{axis.Letter}={profile.RapidAcceleration(axis)}")), .. profile.Axes.All.Select(axis => DmcFormat.Text($"DC{axis.Letter}={profile.RapidAcceleration(axis)}"))];

    /// <summary>Switches the output of the tool on; empty if an axis holds the tool.</summary>
    public static string ToolOn(MachineProfile profile) => profile.Height is null ? Switch(profile.ToolOutput, !profile.ToolActiveLow) : string.Empty;

    /// <summary>Switches the output of the tool off; empty if an axis holds the tool.</summary>
    public static string ToolOff(MachineProfile profile) => profile.Height is null ? Switch(profile.ToolOutput, profile.ToolActiveLow) : string.Empty;

    /// <summary>SB or CB.</summary>
    /// <param name="gap">Between command and number.</param>
    public static string Switch(int output, bool level, string gap = "") => DmcFormat.Text($"{(level ? "SB" : "CB")}{gap}{output}");

    /// <summary>The speed is set first if it is an analog output; the motor of that axis is off, because a servo loop would counteract the offset (galil-dmc.md
    /// C, OF).</summary>
    /// <param name="terms">Of the first stroke; null: as the profile states.</param>
    public static IReadOnlyList<string> SpindleOn(Spindle spindle, StrokeTerms? terms) =>
        [.. spindle.SpeedAxis is { } axis ? (string[])[$"MO{axis}", Analog(axis, terms?.Volts ?? spindle.SpeedVolts)] : [], Switch(spindle.Output, !spindle.IsActiveLow)];

    /// <summary>Switches off what the job has switched on besides the tool: spindle, outputs of operations, power of a beam.</summary>
    public static IReadOnlyList<string> RestOffCommands(MachineProfile profile) =>
    [
        .. SpindleOffCommands(profile),
        .. OutputSwitch.Of(profile.OperationOutputs).Select(output => Switch(output.Output, output.IsActiveLow)),
    ];

    /// <summary>Spindle off, with the analog output of speed or power at 0 V.</summary>
    public static IReadOnlyList<string> SpindleOffCommands(MachineProfile profile) =>
    [
        .. profile.Spindle is { } spindle ? (string[])[Switch(spindle.Output, spindle.IsActiveLow)] : [],
        .. profile.AnalogAxis is { } axis ? (string[])[$"OF{axis}=0"] : [],
    ];

    /// <summary><see cref="RestOffCommands"/> as one statement of a line; empty where there is nothing to switch off.</summary>
    public static string RestOff(MachineProfile profile) => string.Join(';', RestOffCommands(profile));

    /// <summary>The outputs that a program switches by SB or CB, each once.</summary>
    public static IEnumerable<int> SwitchedIn(string program) =>
        program.Split('\n', ';').Select(statement => statement.Trim()).Where(statement => statement.Length == 3 && statement[..2] is "SB" or "CB" && statement[2] is >= '1' and <= '8').Select(statement => statement[2] - '0').Distinct();

    /// <summary>Sets the outputs and the analog output for a stroke, before the machine moves to it; empty where its operation states none.</summary>
    public static IReadOnlyList<string> Outputs(MachineProfile profile, StrokeTerms? terms) => terms is not { SetsOutputs: true } ? [] :
    [
        .. OutputSwitch.Of(terms.Outputs).Select(output => Switch(output.Output, output.IsOn(terms.OutputsOn))),
        .. terms.Volts is { } volts && profile.AnalogAxis is { } axis ? (string[])[Analog(axis, volts)] : [],
    ];

    /// <summary>The same with the wait for the spindle.</summary>
    public static string[] Ready(MachineProfile profile, StrokeTerms? terms) => [.. Outputs(profile, terms), Wait(terms?.ReadySeconds ?? 0.0)];

    /// <summary>Motor of the axis off and no power, before the first stroke sets it; empty where the profile has no axis for the power of a beam.</summary>
    public static IReadOnlyList<string> PowerZero(MachineProfile profile) => profile.Power is { Axis: var axis } ? [$"MO{axis}", $"OF{axis}=0"] : [];

    private static string Analog(char axis, double volts) => DmcFormat.Text($"OF{axis}={DmcFormat.Number(volts)}");

    /// <summary>The wait after a change of the tool; empty when the profile has no settle time.</summary>
    public static string Settle(MachineProfile profile, bool on = true) => profile.SettleMilliseconds(on) == 0 ? string.Empty : DmcFormat.Text($"WT {profile.SettleMilliseconds(on)}");

    /// <summary>Switches the tool off first, then stops every motion of the plane and of its axes. One line, so that other threads cannot run in between. A
    /// spindle keeps turning while its tool may be in the work.</summary>
    public static string StopEverything(MachineProfile profile) => Statements(ToolOff(profile), "STS", "ST" + profile.Axes.Letters, profile.Height is null ? RestOff(profile) : string.Empty);

    /// <summary>Joined by ';', without empty statements.</summary>
    public static string Statements(params ReadOnlySpan<string> statements) => string.Join(';', statements.ToArray().Where(statement => statement.Length > 0));

    /// <summary>Cuts a line in three axes to x, y, z relative to the machine's position (galil-dmc.md EX7), and waits for its end.</summary>
    public static IReadOnlyList<string> SlopeLines(MachineProfile profile, string last) =>
        new ProgramLines().Line(Slope).Line("LM" + profile.Axes.Letters).Line(Speeds).Line("LI " + DmcAxes.Fields(profile.Axes, ["x", "y", "z"])).Line("LE").Line("BGS").Line("AMS").Line(last).Line("EN").Lines;

    /// <summary>A wait that an operation states; empty for none.</summary>
    public static string Wait(double seconds) => seconds > 0.0 ? DmcFormat.Text($"WT {DmcProfile.EvenMilliseconds(seconds)}") : string.Empty;

    /// <summary>Assigns the plunge feed of a stroke; empty where every stroke has that of the profile.</summary>
    public static string PlungeAssignment(MachineProfile profile, StrokeTerms? terms, bool ownPlunges) => ownPlunges ? DmcFormat.Text($"{PlungeSpeed}={profile.PlungeSpeed(terms)}") : string.Empty;

    /// <summary>Whether strokes have plunge feeds other than that of the profile: #DOWN then has it in a variable.</summary>
    public static bool HasOwnPlunges(MotionProgram program) => program.Profile.Height is not null && program.Strokes.Any(stroke => stroke.Terms is { } terms && terms.PlungeSpeed != program.Profile.PlungeSpeed());

    /// <summary>True when the tool is at the height of a variable or above it, as a condition of JP.</summary>
    public static string IsUp(MachineProfile profile, string height) => $"_RP{profile.Axes.Z!.Value.Letter}{(profile.UpSign > 0 ? ">=" : "<=")}{height}";

    /// <summary>Moves the Z axis and waits.</summary>
    public static string HeightLine(MachineProfile profile, int speed, string height) => HeightLine(profile, DmcFormat.Text($"{speed}"), height);

    private static string HeightLine(MachineProfile profile, string speed, string height) => profile.Axes.Z!.Value.Letter is var z ? DmcFormat.Text($"SP{z}={speed};PA{z}={height};BG{z};AM{z}") : "";

    /// <summary>Moves down to the height z: fast to the retract height zr, then at the plunge feed. The tool must be at clearance height before.</summary>
    /// <param name="ownPlunges">The plunge feed is a variable.</param>
    /// <param name="check">A line after each of the two moves, or empty.</param>
    public static IReadOnlyList<string> DownLines(MachineProfile profile, bool ownPlunges, string check, string last) => new ProgramLines()
        .Line(Down)
        .Line("JP#DOWNS," + IsUp(profile, "zr").Replace("_RP" + profile.Axes.Z!.Value.Letter, "z", StringComparison.Ordinal))
        .Line(HeightLine(profile, profile.RapidSpeed(profile.Axes.Z!.Value), "zr"))
        .Line("#DOWNS")
        .Line(HeightLine(profile, ownPlunges ? PlungeSpeed : DmcFormat.Text($"{profile.PlungeSpeed()}"), "z"))
        .Line(check)
        .Line(last)
        .Line("EN")
        .Lines;

    /// <summary>Moves up to clearance height zup, unless the tool is there or higher.</summary>
    public static IReadOnlyList<string> UpLines(MachineProfile profile, string last) => new ProgramLines()
        .Line(Up)
        .Line("JP#UPS," + IsUp(profile, ClearanceHeight))
        .Line(HeightLine(profile, profile.RapidSpeed(profile.Axes.Z!.Value), ClearanceHeight))
        .Line("#UPS")
        .Line(last)
        .Line("EN")
        .Lines;

    private static IReadOnlyList<string> Interpolation(MachineProfile profile, string label, string segment, string last) =>
        new ProgramLines().Line(label).Line("VM" + profile.Axes.PlaneLetters).Line(Speeds).Line(segment).Line("VE").Line("BGS").Line("AMS").Line(last).Line("EN").Lines;
}
