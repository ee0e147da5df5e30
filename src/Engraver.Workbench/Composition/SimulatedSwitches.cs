using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;
using Engraver.Simulator;

namespace Engraver.Workbench.Composition;

/// <summary>Positions of switches and index pulses of a simulated machine from the profile of the real one, relative to the power-on position of the simulated
/// axes.</summary>
/// <remarks>An axis with homing starts away from its mark, so that it has to search; other axes start at machine zero. Limit switches are 1 mm outside the
/// travel.</remarks>
internal static class SimulatedSwitches
{
    /// <summary>Distance of an axis from its mark at power-on, mm; at most a third of its travel.</summary>
    private const double FromMark = 25.0;

    /// <summary>Distance of the limit switches from the travel, mm.</summary>
    private const double OutsideTravel = 1.0;

    /// <summary>Distance of the home switch from the index pulse that is the mark, mm.</summary>
    private const double BehindIndex = 0.7;

    public static IReadOnlyList<AxisSwitches> Switches(MachineProfile profile) => [.. profile.Axes.All.Where(axis => axis.Travel is not null || axis.Homing is not null).Select(Switches)];

    private static AxisSwitches Switches(MachineAxis axis)
    {
        var switches = new AxisSwitches(axis.Letter - 'A');
        var away = axis.Travel is { } length ? Math.Min(FromMark, (length.Max - length.Min) / 3.0) : FromMark;
        var on = axis.Homing is { } mark ? mark.Zero + (mark.Plus ? -away : away) : 0.0;
        int At(double machine) => (int)Math.Clamp(Math.Round(axis.Scale.Exact(machine - on)), int.MinValue, int.MaxValue);
        var mirrored = axis.Scale.IsMirrored;
        if (axis.Travel is { } travel)
        {
            var (least, most) = (At(travel.Min - OutsideTravel), At(travel.Max + OutsideTravel));
            switches = switches with { ReverseLimitAt = mirrored ? most : least, ForwardLimitAt = mirrored ? least : most };
        }

        return axis.Homing is { } homing ? With(switches, homing, At, mirrored) : switches;
    }

    private static AxisSwitches With(AxisSwitches switches, AxisHoming homing, Func<double, int> at, bool mirrored)
    {
        var edge = at(homing.Zero + (homing.HasIndex ? homing.Plus ? BehindIndex : -BehindIndex : 0.0));
        var forward = homing.Plus != mirrored;
        if (homing.HasIndex) switches = switches with { IndexAt = at(homing.Zero) };
        if (homing.ByLimit) return forward ? switches with { ForwardLimitAt = edge } : switches with { ReverseLimitAt = edge };
        return homing.HasSwitch ? switches with { HomeAt = edge, IsHomeBelow = !forward, IsHomeNormallyClosed = homing.OnSwitch == 1 } : switches;
    }
}
