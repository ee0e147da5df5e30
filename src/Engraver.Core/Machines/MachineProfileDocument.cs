namespace Engraver.Core.Machines;

/// <summary>The fields of a profile file; those that are not given keep the default machine profile's value.</summary>
internal sealed class MachineProfileDocument
{
    public string? AxisX { get; set; }

    public string? AxisY { get; set; }

    public double? CountsPerMillimetreX { get; set; }

    public double? CountsPerMillimetreY { get; set; }

    public double? FeedMmPerMinute { get; set; }

    public double? RapidMmPerMinute { get; set; }

    public int? AccelerationCounts { get; set; }

    public double? SharpCornerDegrees { get; set; }

    public int? ToolOutput { get; set; }

    public double? ToolSettleSeconds { get; set; }

    public double? AngleQuantumDegrees { get; set; }

    public double? ParkX { get; set; }

    public double? ParkY { get; set; }

    public static MachineProfileDocument From(MachineProfile profile) => new()
    {
        AxisX = profile.Axes.X.Letter.ToString(),
        AxisY = profile.Axes.Y.Letter.ToString(),
        CountsPerMillimetreX = profile.Axes.X.CountsPerMillimetre,
        CountsPerMillimetreY = profile.Axes.Y.CountsPerMillimetre,
        FeedMmPerMinute = profile.FeedMmPerMinute,
        RapidMmPerMinute = profile.RapidMmPerMinute,
        AccelerationCounts = profile.AccelerationCounts,
        SharpCornerDegrees = profile.SharpCornerDegrees,
        ToolOutput = profile.ToolOutput,
        ToolSettleSeconds = profile.ToolSettleSeconds,
        AngleQuantumDegrees = profile.AngleQuantumDegrees,
        ParkX = profile.ParkX,
        ParkY = profile.ParkY,
    };

    public MachineProfile Over(MachineProfile profile) => new()
    {
        Axes = new MachineAxes(Axis(AxisX, CountsPerMillimetreX, profile.Axes.X), Axis(AxisY, CountsPerMillimetreY, profile.Axes.Y)),
        FeedMmPerMinute = FeedMmPerMinute ?? profile.FeedMmPerMinute,
        RapidMmPerMinute = RapidMmPerMinute ?? profile.RapidMmPerMinute,
        AccelerationCounts = AccelerationCounts ?? profile.AccelerationCounts,
        SharpCornerDegrees = SharpCornerDegrees ?? profile.SharpCornerDegrees,
        ToolOutput = ToolOutput ?? profile.ToolOutput,
        ToolSettleSeconds = ToolSettleSeconds ?? profile.ToolSettleSeconds,
        AngleQuantumDegrees = AngleQuantumDegrees ?? profile.AngleQuantumDegrees,
        ParkX = ParkX ?? profile.ParkX,
        ParkY = ParkY ?? profile.ParkY,
    };

    /// <summary>What is no single letter becomes none that a controller has, for the check of the profile to refuse.</summary>
    private static MachineAxis Axis(string? letter, double? countsPerMillimetre, MachineAxis otherwise) =>
        new(letter is null ? otherwise.Letter : letter.Length == 1 ? letter[0] : MachineProfileValidation.NoLetter, countsPerMillimetre ?? otherwise.CountsPerMillimetre);
}
