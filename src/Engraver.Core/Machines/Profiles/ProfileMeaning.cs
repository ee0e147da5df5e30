using Engraver.Core.Drawings;
using Engraver.Core.Machines.Moves;

namespace Engraver.Core.Machines.Profiles;

/// <summary>What a machine profile means, in sentences for the owner of the machine.</summary>
public static class ProfileMeaning
{
    public static IReadOnlyList<string> Of(MachineProfile profile)
    {
        ArgumentNullException.ThrowIfNull(profile);
        return [.. Axes(profile), .. Speeds(profile), .. Tool(profile), .. Places(profile), Cost(profile)];
    }

    private static IEnumerable<string> Axes(MachineProfile profile)
    {
        foreach (var (name, axis) in profile.Axes.Named)
        {
            var count = axis.Scale.LengthOf(1.0);
            yield return Wording.Get(axis.Scale.IsMirrored ? "ProfileMeaning.AxisMirrored" : "ProfileMeaning.Axis", name, axis.Letter, axis.Scale.CountsOf(1.0), count, LengthUnits.InInches(count));
            if (axis.MotorType is { } motor) yield return Wording.Get("ProfileMeaning.Motor", name, motor);
            yield return axis.Travel is { } travel ? Wording.Get("ProfileMeaning.Travel", name, travel.Min, travel.Max) : Wording.Get("ProfileMeaning.NoTravel", name);
        }

        if (!profile.Scale.IsUniform) yield return Wording.Get("ProfileMeaning.Chords");
    }

    private static IEnumerable<string> Speeds(MachineProfile profile)
    {
        var (feed, acceleration) = (profile.FeedMmPerMinute / 60.0, profile.Scale.Finer.LengthOf(profile.AccelerationCounts));
        yield return Wording.Get("ProfileMeaning.Feed", profile.FeedMmPerMinute, feed, profile.RapidMmPerMinute, profile.JogMmPerMinute);
        yield return Wording.Get("ProfileMeaning.FollowingError", profile.FollowingErrorAt(feed), profile.FollowingErrorAt(profile.FastestMmPerSecond));
        yield return Wording.Get("ProfileMeaning.Acceleration", acceleration, feed / acceleration, feed * feed / acceleration / 2.0);
    }

    private static IEnumerable<string> Tool(MachineProfile profile)
    {
        yield return profile.Height is { } height
            ? Wording.Get("ProfileMeaning.ToolAxis", height.ClearanceHeight, height.RetractHeight, height.PlungeMmPerMinute, height.CutDepth)
            : Wording.Get(profile.ToolActiveLow ? "ProfileMeaning.ToolOutputLow" : "ProfileMeaning.ToolOutput", profile.ToolOutput, profile.ToolSettleSeconds, profile.OffSettleSeconds);
        if (profile.Height?.DepthPerPass is { } step) yield return Wording.Get("ProfileMeaning.Passes", step);
        if (profile.Power is { } power) yield return Wording.Get("ProfileMeaning.Power", power.Axis, power.Volts);
        if (profile.Spindle is not { } spindle) yield break;
        yield return Wording.Get(spindle.IsActiveLow ? "ProfileMeaning.SpindleLow" : "ProfileMeaning.Spindle", spindle.Output, spindle.SpinUpSeconds);
        if (spindle.SpeedAxis is { } axis) yield return Wording.Get("ProfileMeaning.SpindleVolts", axis, spindle.SpeedVolts);
        if (spindle.FullSpeed is { } full) yield return Wording.Get("ProfileMeaning.FullSpeed", full, spindle.SpeedVolts);
    }

    private static IEnumerable<string> Places(MachineProfile profile)
    {
        var homed = profile.Axes.Named.Where(named => named.Axis.Homing is not null).OrderBy(named => named.Axis.Homing!.Order).ToList();
        if (homed.Count == 0) yield return Wording.Get("ProfileMeaning.NotHomed");
        foreach (var (name, axis) in homed) yield return Wording.Get(axis.Homing!.Plus ? "ProfileMeaning.HomedUp" : "ProfileMeaning.HomedDown", name, Mark(axis.Homing), axis.Homing.FastMmPerMinute, axis.Homing.Zero);
        if (profile.Park is { } park) yield return Wording.Get("ProfileMeaning.Park", park.X, park.Y);
        if (profile.Inputs.All.Count > 0) yield return Wording.Get("ProfileMeaning.Inputs", Named(profile.Inputs));
        if (profile.Outputs.All.Count > 0) yield return Wording.Get("ProfileMeaning.Outputs", Named(profile.Outputs));
    }

    private static string Mark(AxisHoming homing) => Wording.Get((homing.ByLimit, homing.HasSwitch, homing.HasIndex) switch
    {
        (true, _, false) => "ProfileMeaning.ByLimit",
        (true, _, true) => "ProfileMeaning.ByLimitIndex",
        (_, true, false) => "ProfileMeaning.BySwitch",
        (_, true, true) => "ProfileMeaning.BySwitchIndex",
        _ => "ProfileMeaning.ByIndex",
    });

    private static string Cost(MachineProfile profile) => profile.Rates is { } rates ? Wording.Get("ProfileMeaning.Cost", rates.PerHour, rates.PerMetre, rates.PerStart) : Wording.Get("ProfileMeaning.NoCost");

    private static string Named(IoLineNames names) => string.Join(", ", names.All.Select(line => $"{line.Key} = {line.Value}"));
}
