using Engraver.Core.Machines.Moves;

namespace Engraver.Core.Machines.Profiles;

/// <summary>The homing of one axis in a profile file; the list's order is the order in which axes are homed.</summary>
internal sealed class HomingDocument
{
    /// <summary>X, Y or Z: the axis of the drawing.</summary>
    public string? Axis { get; set; }

    /// <summary>switch, limit, index, switchIndex or limitIndex.</summary>
    public string? By { get; set; }

    /// <summary>plus or minus.</summary>
    public string? Direction { get; set; }

    public int? OnSwitch { get; set; }

    public double? FastMmPerMinute { get; set; }

    public double? SlowMmPerMinute { get; set; }

    public double? BackOff { get; set; }

    public double? Zero { get; set; }

    public double? Seconds { get; set; }

    public static List<HomingDocument>? From(MachineAxes axes)
    {
        var homed = axes.All.Select((axis, index) => (axis.Homing, Name: MachineAxes.Names[index].ToString())).Where(axis => axis.Homing is not null).OrderBy(axis => axis.Homing!.Order).ToList();
        return homed.Count == 0 ? null : [.. homed.Select(axis => From(axis.Homing!, axis.Name))];
    }

    /// <summary>Invalid text becomes a value that the check of the profile refuses.</summary>
    public AxisHoming ToHoming(int order)
    {
        var usual = new AxisHoming();
        return new AxisHoming
        {
            By = Enum.TryParse<HomingMark>(By, ignoreCase: true, out var mark) && Enum.IsDefined(mark) && !char.IsDigit(By![0]) ? mark : (HomingMark)(-1),
            OnSwitch = OnSwitch ?? usual.OnSwitch,
            Plus = Direction == "plus",
            FastMmPerMinute = FastMmPerMinute ?? usual.FastMmPerMinute,
            SlowMmPerMinute = SlowMmPerMinute ?? usual.SlowMmPerMinute,
            BackOff = BackOff ?? usual.BackOff,
            Zero = Zero ?? usual.Zero,
            Seconds = Seconds ?? usual.Seconds,
            Order = Direction is "plus" or "minus" ? order : -1,
        };
    }

    private static HomingDocument From(AxisHoming homing, string axis) => new()
    {
        Axis = axis,
        By = char.ToLowerInvariant(homing.By.ToString()[0]) + homing.By.ToString()[1..],
        Direction = homing.Plus ? "plus" : "minus",
        OnSwitch = homing.OnSwitch,
        FastMmPerMinute = homing.FastMmPerMinute,
        SlowMmPerMinute = homing.SlowMmPerMinute,
        BackOff = homing.BackOff,
        Zero = homing.Zero,
        Seconds = homing.Seconds,
    };
}
