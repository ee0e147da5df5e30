using Engraver.Core.Diagnostics;
using Engraver.Core.Machines.Moves;
using static Engraver.Core.Machines.Profiles.MachineProfileValidation;

namespace Engraver.Core.Machines.Profiles;

/// <summary>Checks the part of a profile that moves by hand and homing use: jog speed, travel, homing, names of inputs and outputs.</summary>
internal static class HandMoveValidation
{
    private const double LongestHomingSeconds = 3600.0;

    public static IEnumerable<Diagnostic> Findings(MachineProfile profile, MachineLimits limits)
    {
        if (!IsSpeed(profile.JogMmPerMinute, profile, limits)) yield return Finding("jogMmPerMinute", profile.JogMmPerMinute, AxisSpeeds(limits));
        foreach (var (name, axis) in profile.Axes.Named)
        {
            if (axis.Travel is { } travel && !(travel.Min < travel.Max && double.IsFinite(travel.Min) && double.IsFinite(travel.Max) && IsCountable(travel, axis)))
                yield return Text($"travel{name}", $"{NumberText.Exact(travel.Min)}..{NumberText.Exact(travel.Max)}", Wording.Get("MachineProfileValidation.Travel"));
            if (axis.Homing is not { } homing) continue;
            foreach (var finding in Homing(name, axis, homing, limits)) yield return finding;
        }

        foreach (var finding in Names("inputs", profile.Inputs)) yield return finding;
        foreach (var finding in Names("outputs", profile.Outputs)) yield return finding;

        IEnumerable<Diagnostic> Names(string field, IoLineNames names) => names.All
            .Where(entry => entry.Key < 1 || entry.Key > limits.Outputs || entry.Value.Trim().Length == 0 || entry.Value.Any(char.IsWhiteSpace) || int.TryParse(entry.Value, out _) || names.All.Any(other => other.Key < entry.Key && other.Value.Equals(entry.Value, StringComparison.OrdinalIgnoreCase)))
            .Select(entry => Text($"{field}.{entry.Key}", entry.Value, Wording.Get("MachineProfileValidation.LineName", limits.Outputs)));
    }

    private static IEnumerable<Diagnostic> Homing(char name, MachineAxis axis, AxisHoming homing, MachineLimits limits)
    {
        if (!Enum.IsDefined(homing.By)) yield return Text($"homing.{name}.by", "?", Wording.Get("MachineProfileValidation.HomingBy"));
        if (homing.Order < 0) yield return Text($"homing.{name}.direction", "?", Wording.Get("MachineProfileValidation.HomingDirection"));
        if (homing.OnSwitch is not (0 or 1)) yield return Finding($"homing.{name}.onSwitch", homing.OnSwitch, Wording.Get("MachineProfileValidation.HomingOnSwitch"));
        foreach (var (field, speed) in new[] { ("fastMmPerMinute", homing.FastMmPerMinute), ("slowMmPerMinute", homing.SlowMmPerMinute) })
        {
            if (!IsSpeed(axis.Scale.CountsOf(speed / 60.0), limits)) yield return Finding($"homing.{name}.{field}", speed, AxisSpeeds(limits));
        }

        if (homing.SlowMmPerMinute > homing.FastMmPerMinute) yield return Finding($"homing.{name}.slowMmPerMinute", homing.SlowMmPerMinute, Wording.Get("MachineProfileValidation.AtMostHomingFast"));
        if (!(homing.BackOff >= 0.0 && homing.BackOff < 1e6 && axis.Scale.IsUsable && axis.Scale.CountsOf(homing.BackOff) < int.MaxValue)) yield return Finding($"homing.{name}.backOff", homing.BackOff, Wording.Get("MachineProfileValidation.HomingBackOff"));
        var rest = homing.Zero + ((homing.Plus ? -1.0 : 1.0) * homing.BackOff);
        if (!(Math.Abs(axis.Scale.Exact(homing.Zero)) < int.MaxValue && Math.Abs(axis.Scale.Exact(rest)) < int.MaxValue)) yield return Finding($"homing.{name}.zero", homing.Zero, Wording.Get("MachineProfileValidation.PositionWithinCounters"));
        else if (axis.Travel is { } travel && (rest < travel.Min || rest > travel.Max)) yield return Finding($"homing.{name}.zero", homing.Zero, Wording.Get("MachineProfileValidation.HomingInTravel", NumberText.Exact(rest), NumberText.Exact(travel.Min), NumberText.Exact(travel.Max)));
        if (homing.Seconds is not (> 0.0 and <= LongestHomingSeconds)) yield return Finding($"homing.{name}.seconds", homing.Seconds, Wording.Get("MachineProfileValidation.HomingSeconds", LongestHomingSeconds));
    }

    private static bool IsCountable(AxisTravel travel, MachineAxis axis) => !axis.Scale.IsUsable || axis.Scale.CountsOf(Math.Max(Math.Abs(travel.Min), Math.Abs(travel.Max))) < int.MaxValue;

    private static Diagnostic Text(string setting, string value, string limit) => MotionRules.SettingOutOfRange.At(default, setting, value, limit);
}
