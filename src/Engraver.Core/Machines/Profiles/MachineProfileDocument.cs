using System.Text.Json.Serialization;

namespace Engraver.Core.Machines.Profiles;

/// <summary>The fields of a profile file; missing fields keep the default machine profile's value.</summary>
internal sealed class MachineProfileDocument
{
    /// <summary>Key of a controller family; null for the program's default.</summary>
    [JsonIgnore(Condition = JsonIgnoreCondition.WhenWritingNull)]
    public string? Controller { get; set; }

    public string? AxisX { get; set; }

    public string? AxisY { get; set; }

    public string? AxisZ { get; set; }

    public double? CountsPerMillimetreX { get; set; }

    public double? CountsPerMillimetreY { get; set; }

    public double? CountsPerMillimetreZ { get; set; }

    public double? FeedMmPerMinute { get; set; }

    public double? RapidMmPerMinute { get; set; }

    public int? AccelerationCounts { get; set; }

    public int? AccelerationX { get; set; }

    public int? AccelerationY { get; set; }

    /// <summary>Of earlier versions; has no effect.</summary>
    [JsonIgnore(Condition = JsonIgnoreCondition.WhenWritingNull)]
    public double? SharpCornerDegrees { get; set; }

    public double? FollowingErrorMm { get; set; }

    public int? ToolOutput { get; set; }

    public double? ToolSettleSeconds { get; set; }

    public double? AngleQuantumDegrees { get; set; }

    public double? ParkX { get; set; }

    public double? ParkY { get; set; }

    public double? JogMmPerMinute { get; set; }

    public TravelDocument? TravelX { get; set; }

    public TravelDocument? TravelY { get; set; }

    public TravelDocument? TravelZ { get; set; }

    public List<HomingDocument>? Homing { get; set; }

    public Dictionary<string, string?>? Inputs { get; set; }

    public Dictionary<string, string?>? Outputs { get; set; }

    public static MachineProfileDocument From(MachineProfile profile) => new()
    {
        Controller = profile.Controller?.Key,
        AxisX = profile.Axes.X.Letter.ToString(),
        AxisY = profile.Axes.Y.Letter.ToString(),
        AxisZ = profile.Axes.Z?.Letter.ToString(),
        CountsPerMillimetreX = profile.Axes.X.CountsPerMillimetre,
        CountsPerMillimetreY = profile.Axes.Y.CountsPerMillimetre,
        CountsPerMillimetreZ = profile.Axes.Z?.CountsPerMillimetre,
        FeedMmPerMinute = profile.FeedMmPerMinute,
        RapidMmPerMinute = profile.RapidMmPerMinute,
        AccelerationCounts = profile.AccelerationCounts,
        AccelerationX = profile.AccelerationX,
        AccelerationY = profile.AccelerationY,
        FollowingErrorMm = profile.FollowingErrorMm,
        ToolOutput = profile.ToolOutput,
        ToolSettleSeconds = profile.ToolSettleSeconds,
        AngleQuantumDegrees = profile.AngleQuantumDegrees,
        ToolDrive = profile.Height is null ? OutputDrive : AxisDrive,
        ToolActiveLow = profile.ToolActiveLow,
        ToolOffSettleSeconds = profile.ToolOffSettleSeconds,
        ClearanceHeight = profile.Height?.ClearanceHeight,
        RetractHeight = profile.Height?.RetractHeight,
        CutDepth = profile.Height?.CutDepth,
        PlungeMmPerMinute = profile.Height?.PlungeMmPerMinute,
        DepthPerPass = profile.Height?.DepthPerPass,
        SpindleOutput = profile.Spindle?.Output,
        SpindleActiveLow = profile.Spindle?.IsActiveLow,
        SpindleSeconds = profile.Spindle?.SpinUpSeconds,
        SpindleAxis = profile.Spindle?.SpeedAxis?.ToString(),
        SpindleVolts = profile.Spindle?.SpeedAxis is null ? null : profile.Spindle.SpeedVolts,
        SpindleFullSpeed = profile.Spindle?.FullSpeed,
        SpindleStopsInHold = profile.Spindle?.StopsInHold,
        PowerAxis = profile.Power?.Axis.ToString(),
        PowerVolts = profile.Power?.Volts,
        MotorTypeX = profile.Axes.X.MotorType,
        MotorTypeY = profile.Axes.Y.MotorType,
        MotorTypeZ = profile.Axes.Z?.MotorType,
        ParkX = profile.ParkX,
        ParkY = profile.ParkY,
        JogMmPerMinute = profile.JogMmPerMinute,
        TravelX = TravelDocument.From(profile.Axes.X.Travel),
        TravelY = TravelDocument.From(profile.Axes.Y.Travel),
        TravelZ = TravelDocument.From(profile.Axes.Z?.Travel),
        Homing = HomingDocument.From(profile.Axes),
        Inputs = IoNamesDocument.From(profile.Inputs),
        Outputs = IoNamesDocument.From(profile.Outputs),
        CostPerHour = profile.Rates?.PerHour,
        CostPerMetre = profile.Rates?.PerMetre,
        CostPerStart = profile.Rates?.PerStart,
    };

    /// <param name="controller">The family that <see cref="Controller"/> names.</param>
    public MachineProfile Over(MachineProfile profile, IControllerFamily? controller) => new()
    {
        Controller = controller,
        Axes = new MachineAxes(Axis('X', AxisX, CountsPerMillimetreX, MotorTypeX, TravelX, profile.Axes.X), Axis('Y', AxisY, CountsPerMillimetreY, MotorTypeY, TravelY, profile.Axes.Y), AxisOfHeight(profile.Axes.Z)),
        FeedMmPerMinute = FeedMmPerMinute ?? profile.FeedMmPerMinute,
        RapidMmPerMinute = RapidMmPerMinute ?? profile.RapidMmPerMinute,
        AccelerationCounts = AccelerationCounts ?? profile.AccelerationCounts,
        AccelerationX = AccelerationX ?? profile.AccelerationX,
        AccelerationY = AccelerationY ?? profile.AccelerationY,
        FollowingErrorMm = FollowingErrorMm ?? profile.FollowingErrorMm,
        ToolOutput = ToolOutput ?? profile.ToolOutput,
        ToolSettleSeconds = ToolSettleSeconds ?? profile.ToolSettleSeconds,
        AngleQuantumDegrees = AngleQuantumDegrees ?? profile.AngleQuantumDegrees,
        ToolActiveLow = ToolActiveLow ?? profile.ToolActiveLow,
        ToolOffSettleSeconds = ToolOffSettleSeconds ?? profile.ToolOffSettleSeconds,
        Height = ToolDrive is null ? profile.Height : ToolDrive == AxisDrive ? HeightOver(profile.Height ?? new HeightDrive()) : null,
        Spindle = SpindleOutput is null ? profile.Spindle : SpindleOver(profile.Spindle ?? new Spindle()),
        Power = PowerAxis is null ? profile.Power : new AnalogOutput(Letter(PowerAxis), PowerVolts ?? profile.Power?.Volts ?? 0.0),
        ParkX = ParkX ?? profile.ParkX,
        ParkY = ParkY ?? profile.ParkY,
        JogMmPerMinute = JogMmPerMinute ?? Math.Min(profile.JogMmPerMinute, RapidMmPerMinute ?? profile.RapidMmPerMinute), // at most the rapid speed
        Inputs = IoNamesDocument.ToNames(Inputs),
        Outputs = IoNamesDocument.ToNames(Outputs),
        Rates = CostPerHour is null && CostPerMetre is null && CostPerStart is null ? profile.Rates : new JobRates(CostPerHour ?? 0.0, CostPerMetre ?? 0.0, CostPerStart ?? 0.0),
    };

    /// <summary>A machine has a Z axis when its profile gives its letter or its counts; the check of the profile refuses one without the other.</summary>
    private MachineAxis? AxisOfHeight(MachineAxis? otherwise) =>
        AxisZ is null && CountsPerMillimetreZ is null && MotorTypeZ is null ? otherwise : Axis('Z', AxisZ, CountsPerMillimetreZ, MotorTypeZ, TravelZ, otherwise ?? new MachineAxis(MachineProfileValidation.NoLetter, 0.0));

    /// <summary>The entries of the list of homings that do not name an axis of this machine, or name one again.</summary>
    public IEnumerable<string> HomingsWithoutAxis(MachineAxes axes) =>
        (Homing ?? []).Where((entry, i) => entry?.Axis is not { Length: 1 } name || MachineAxes.Names.IndexOf(name[0], StringComparison.Ordinal) is not (>= 0 and var at) || at >= axes.All.Count || Homing!.FindIndex(other => other?.Axis == name) != i)
            .Select(entry => entry?.Axis ?? "");

    /// <param name="name">X, Y or Z.</param>
    /// <remarks>A text that is not a single letter becomes a letter that no controller has, which the check of the profile refuses.</remarks>
    private MachineAxis Axis(char name, string? letter, double? countsPerMillimetre, double? motorType, TravelDocument? travel, MachineAxis otherwise)
    {
        var order = Homing?.FindIndex(entry => entry?.Axis == name.ToString()) ?? -1;
        return new MachineAxis(letter is null ? otherwise.Letter : Letter(letter), countsPerMillimetre ?? otherwise.CountsPerMillimetre, motorType ?? otherwise.MotorType)
        {
            Travel = travel?.ToTravel() ?? otherwise.Travel,
            Homing = order >= 0 ? Homing![order].ToHoming(order) : otherwise.Homing,
        };
    }

    /// <summary>The two kinds of tool drive.</summary>
    private const string OutputDrive = "output";
    private const string AxisDrive = "axis";

    public string? ToolDrive { get; set; }

    public bool? ToolActiveLow { get; set; }

    public double? ToolOffSettleSeconds { get; set; }

    public double? ClearanceHeight { get; set; }

    public double? RetractHeight { get; set; }

    public double? CutDepth { get; set; }

    public double? PlungeMmPerMinute { get; set; }

    public double? DepthPerPass { get; set; }

    public int? SpindleOutput { get; set; }

    public bool? SpindleActiveLow { get; set; }

    public double? SpindleSeconds { get; set; }

    public string? SpindleAxis { get; set; }

    public double? SpindleVolts { get; set; }

    public double? SpindleFullSpeed { get; set; }

    public bool? SpindleStopsInHold { get; set; }

    public string? PowerAxis { get; set; }

    public double? PowerVolts { get; set; }

    public double? MotorTypeX { get; set; }

    public double? MotorTypeY { get; set; }

    public double? MotorTypeZ { get; set; }

    public double? CostPerHour { get; set; }

    public double? CostPerMetre { get; set; }

    public double? CostPerStart { get; set; }

    private static char Letter(string text) => text.Length == 1 ? text[0] : MachineProfileValidation.NoLetter;

    private HeightDrive HeightOver(HeightDrive drive) => new()
    {
        ClearanceHeight = ClearanceHeight ?? drive.ClearanceHeight,
        RetractHeight = RetractHeight ?? drive.RetractHeight,
        CutDepth = CutDepth ?? drive.CutDepth,
        PlungeMmPerMinute = PlungeMmPerMinute ?? drive.PlungeMmPerMinute,
        DepthPerPass = DepthPerPass ?? drive.DepthPerPass,
    };

    private Spindle SpindleOver(Spindle spindle) => new()
    {
        Output = SpindleOutput ?? spindle.Output,
        IsActiveLow = SpindleActiveLow ?? spindle.IsActiveLow,
        SpinUpSeconds = SpindleSeconds ?? spindle.SpinUpSeconds,
        SpeedAxis = SpindleAxis is null ? spindle.SpeedAxis : Letter(SpindleAxis),
        SpeedVolts = SpindleVolts ?? spindle.SpeedVolts,
        FullSpeed = SpindleFullSpeed ?? spindle.FullSpeed,
        StopsInHold = SpindleStopsInHold ?? spindle.StopsInHold,
    };

    /// <summary>Fields that have an effect only beside another one, which is missing: they would be ignored silently.</summary>
    public IEnumerable<(string Field, string Needs)> WithoutEffect()
    {
        if (ToolDrive != AxisDrive)
        {
            if (ClearanceHeight is not null) yield return ("clearanceHeight", Needs("toolDrive", AxisDrive));
            if (RetractHeight is not null) yield return ("retractHeight", Needs("toolDrive", AxisDrive));
            if (CutDepth is not null) yield return ("cutDepth", Needs("toolDrive", AxisDrive));
            if (PlungeMmPerMinute is not null) yield return ("plungeMmPerMinute", Needs("toolDrive", AxisDrive));
            if (DepthPerPass is not null) yield return ("depthPerPass", Needs("toolDrive", AxisDrive));
        }

        if (SpindleOutput is null)
        {
            if (SpindleActiveLow is not null) yield return ("spindleActiveLow", Beside("spindleOutput"));
            if (SpindleSeconds is not null) yield return ("spindleSeconds", Beside("spindleOutput"));
            if (SpindleAxis is not null) yield return ("spindleAxis", Beside("spindleOutput"));
            if (SpindleStopsInHold is not null) yield return ("spindleStopsInHold", Beside("spindleOutput"));
        }

        if (SpindleFullSpeed is not null && (SpindleAxis is null || SpindleOutput is null)) yield return ("spindleFullSpeed", Beside("spindleAxis"));
        if (PowerVolts is not null && PowerAxis is null) yield return ("powerVolts", Beside("powerAxis"));
        if (PowerAxis is not null && PowerVolts is null) yield return ("powerAxis", Beside("powerVolts"));
        if (SpindleVolts is not null && (SpindleAxis is null || SpindleOutput is null)) yield return ("spindleVolts", Beside("spindleAxis"));
        if (ToolDrive is not (null or OutputDrive or AxisDrive)) yield return ("toolDrive", Wording.Get("MachineProfileValidation.OneOfDrives", OutputDrive, AxisDrive));
    }

    private static string Needs(string field, string value) => Beside($"\"{field}\": \"{value}\"");

    private static string Beside(string field) => Wording.Get("MachineProfileValidation.NoValueWithout", field);
}
