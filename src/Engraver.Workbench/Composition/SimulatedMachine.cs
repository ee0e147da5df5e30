using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;
using Engraver.Simulator;

namespace Engraver.Workbench.Composition;

/// <summary>Where the switches and index pulses of a simulated machine lie, as a profile describes the real one: from where the simulated axes stand when
/// they are switched on.</summary>
/// <remarks>An axis that is homed is switched on away from its mark, so that it has to search; another stands at its machine zero. Limit switches lie 1 mm
/// outside the travel.</remarks>
internal static class SimulatedMachine
{
    /// <summary>How far from its mark an axis stands at power-on, mm; within a third of its travel.</summary>
    private const double FromMark = 25.0;

    /// <summary>How far outside the travel the limit switches lie, mm.</summary>
    private const double OutsideTravel = 1.0;

    /// <summary>How far behind the index pulse that is the mark the switch before it lies, mm.</summary>
    private const double BehindIndex = 0.7;

    public static IReadOnlyList<AxisSwitches> Switches(MachineProfile profile) => [.. profile.Axes.All.Where(axis => axis.Travel is not null || axis.Homing is not null).Select(Switches)];

    private static AxisSwitches Switches(MachineAxis axis)
    {
        var switches = new AxisSwitches(axis.Letter - 'A');
        var away = axis.Travel is { } length ? Math.Min(FromMark, (length.Most - length.Least) / 3.0) : FromMark;
        var on = axis.Homing is { } mark ? mark.Zero + (mark.Plus ? -away : away) : 0.0;
        int At(double machine) => (int)Math.Clamp(Math.Round(axis.Scale.Exact(machine - on)), int.MinValue, int.MaxValue);
        var mirrored = axis.Scale.IsMirrored;
        if (axis.Travel is { } travel)
        {
            var (least, most) = (At(travel.Least - OutsideTravel), At(travel.Most + OutsideTravel));
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
